use super::Maker;
pub fn makers() -> Vec<Maker> {
    Vec::new()
}
