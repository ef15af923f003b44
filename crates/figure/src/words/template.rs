//! Templates: text in which the fields of an event are filled in.

use raystep_accel::Value;

use crate::words::{Fact, Piece, ROUGH, come_out, number, one_or_many, value};

/// The template with each `{{field}}` replaced by that field's value; what the event lacks stays as it is.
/// `{{prims reference}}` counts: 1 reference, 2 references; `{{lanes ray}}` counts those that take part; and
/// `{{prims primitive is|primitives are}}` says both itself. Sums come out in the digits that are shown.
pub fn fill(template: &str, event: &(impl Fact + ?Sized)) -> String {
    let mut pieces = Vec::new();
    // The text since the last number.
    let mut filled = String::new();
    let mut rest = template;
    while let Some(start) = rest.find("{{") {
        let (before, opened) = rest.split_at(start);
        filled.push_str(before);
        let Some(end) = opened.find("}}") else {
            rest = opened;
            break;
        };
        let inside = opened[2..end].trim();
        let (field, noun) = inside.split_once(' ').unwrap_or((inside, ""));
        match event.field(field) {
            Some(Value::Lanes(lanes)) if !noun.is_empty() => {
                filled.push_str(&value(&Value::Count(lanes.count())));
                filled.extend([" ", &one_or_many(lanes.count() == 1, noun)]);
            }
            Some(Value::Number(x)) => {
                // Nobody reads "3.5 − −1".
                if event.is_rough(field) {
                    filled.push_str(ROUGH);
                }
                let bracketed = x < 0.0 && filled.trim_end().ends_with(['−', '-', '+', '·', '/']);
                pieces.extend([Piece::Text(std::mem::take(&mut filled)), Piece::Number { x, bracketed }]);
                if !noun.is_empty() {
                    filled.extend([" ", &one_or_many(number(x) == "1", noun)]);
                }
            }
            Some(Value::Count(n)) if !noun.is_empty() => {
                filled.push_str(&value(&Value::Count(n)));
                filled.extend([" ", &one_or_many(n == 1, noun)]);
            }
            // What is not measured yet will be many.
            Some(waits @ Value::Word(..)) if !noun.is_empty() => {
                filled.push_str(&value(&waits));
                filled.extend([" ", &one_or_many(false, noun)]);
            }
            Some(found) => filled.push_str(&value(&found)),
            None => filled.push_str(&opened[..end + 2]),
        }
        rest = &opened[end + 2..];
    }
    pieces.push(Piece::Text(filled + rest));
    // An interval that nothing was left of from the start has no numbers.
    come_out(&pieces).replace("[∞, −∞]", "empty").replace("∞ ≤ −∞ ?", "empty:")
}

/// The template filled as prose: a place that begins a sentence begins with a capital letter.
pub fn told(template: &str, event: &(impl Fact + ?Sized)) -> String {
    let filled = fill(template, event);
    let mut told = String::with_capacity(filled.len());
    let mut begins = true;
    for (at, letter) in filled.char_indices() {
        let rest = &filled[at..];
        let place = ["primitive ", "node ", "cell ", "the box"].iter().any(|word| rest.starts_with(word));
        if begins && place {
            told.extend(letter.to_uppercase());
        } else {
            told.push(letter);
        }
        begins = letter == '\n' || letter == ' ' && told.trim_end().ends_with(['.', '?', '!']);
    }
    told
}

#[cfg(test)]
mod tests {
    use raystep_accel::{Axis, NodeId, Visit};

    use super::*;

    #[test]
    fn templates_are_filled_from_the_event() {
        let event = Visit::Plane {
            node: NodeId(1),
            axis: Axis::Y.into(),
            plane: 2.02,
            o: 0.53,
            d: 0.407,
            t: 3.661,
            t_near: 0.328,
            t_far: 5.14,
        };
        assert_eq!(
            fill("{{axis}} = {{plane}} cuts {{ node }} at {{t}}; {{other}} {t}", &event),
            "y = 2.02 cuts node 1 at 3.66; {{other}} {t}"
        );
        assert_eq!(told("{{node}} is cut. {{node}} waits", &event), "Node 1 is cut. Node 1 waits");
        assert_eq!(fill("{{t", &event), "{{t");
        let place = raystep_accel::Place::Node(NodeId(3));
        let leaf = |prims| Visit::Enter { place, t_near: 0.0, t_far: 1.0, prims, leaf: true };
        assert_eq!(fill("{{prims reference}}, {{prims}}", &leaf(1)), "1 reference, 1");
        assert_eq!(fill("{{prims reference}}", &leaf(0)), "0 references");
        assert_eq!(fill("{{prims box}}, {{prims box}}", &leaf(3)), "3 boxes, 3 boxes");
        let counted = "{{prims leaf is|leaves are}} left, at {{t_far second}}, {{t_near cell}}";
        assert_eq!(fill(counted, &leaf(1)), "1 leaf is left, at 1 second, 0 cells");
        assert_eq!(fill(counted, &leaf(2)), "2 leaves are left, at 1 second, 0 cells");
        let event = Visit::Enter { place, t_near: f32::INFINITY, t_far: f32::NEG_INFINITY, prims: 0, leaf: true };
        assert_eq!(fill("{{place}}  [{{t_near}}, {{t_far}}]", &event), "node 3  empty");
        let event = Visit::Test { prim: raystep_accel::PrimId(0), t: -1.0, hit: true };
        assert_eq!(fill("3 − {{t}}, {{t}} − 3", &event), "3 − (−1), −1 − 3");
    }
}
