//! Events as lines of text.

use std::fmt::Write;

use raystep_accel::Value;

/// The name and the fields of an event.
pub(crate) fn line(name: &str, fields: &[&'static str], value: impl Fn(&str) -> Option<Value>) -> String {
    let mut line = format!("{name:<13}");
    for field in fields {
        let value = match value(field).unwrap() {
            Value::Number(number) => format!("{}", (number * 1000.0).round() / 1000.0),
            Value::Count(count) => count.to_string(),
            Value::Flag(flag) => flag.to_string(),
            Value::Axis(axis) => axis.to_string(),
            Value::Word(word, _) => word.to_owned(),
            Value::Place(place) => place.to_string(),
            Value::Box(bounds) => format!("{} {}", bounds.min, bounds.max),
            Value::Lanes(lanes) => lanes.to_string(),
        };
        write!(line, " {field}={value}").unwrap();
    }
    line
}
