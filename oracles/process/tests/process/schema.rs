//! What a JSON Schema says of a value: the few keywords that the schemas of the protocol use, and an error for any other.

use std::path::Path;

use regex::Regex;
use serde_json::{Map, Value};

/// The schema of a message of the protocol.
pub struct Schema(Value);

impl Schema {
    /// Reads the schema of this name.
    pub fn read(name: &str) -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/protocol/v1");
        let text = std::fs::read_to_string(folder.join(name).with_extension("json")).unwrap();
        Self(serde_json::from_str(&text).unwrap())
    }

    /// Whether it holds of this text.
    pub fn allows(&self, text: &str) -> bool {
        serde_json::from_str(text).is_ok_and(|value| self.holds(&self.0, &value))
    }

    fn holds(&self, schema: &Value, value: &Value) -> bool {
        let schema = schema.as_object().unwrap();
        schema.iter().all(|(keyword, wanted)| self.keyword(schema, keyword, wanted, value))
    }

    fn keyword(&self, schema: &Map<String, Value>, keyword: &str, wanted: &Value, value: &Value) -> bool {
        let schemas = || wanted.as_array().unwrap().iter();
        let holding = || schemas().filter(|schema| self.holds(schema, value)).count();
        let number = |holds: fn(f64, f64) -> bool| value.as_f64().is_none_or(|v| holds(v, wanted.as_f64().unwrap()));
        let length = || value.as_array().map(|items| items.len() as u64);
        match keyword {
            "$schema" | "title" | "description" | "$defs" => true,
            "$ref" => self.holds(self.0.pointer(&wanted.as_str().unwrap()[1..]).unwrap(), value),
            "type" => is_of_type(wanted.as_str().unwrap(), value),
            "const" => value == wanted,
            "enum" => wanted.as_array().unwrap().contains(value),
            "minimum" => number(|value, least| value >= least),
            "maximum" => number(|value, most| value <= most),
            "exclusiveMinimum" => number(|value, least| value > least),
            "exclusiveMaximum" => number(|value, most| value < most),
            "minItems" => length().is_none_or(|length| length >= wanted.as_u64().unwrap()),
            "maxItems" => length().is_none_or(|length| length <= wanted.as_u64().unwrap()),
            "items" => value.as_array().is_none_or(|items| items.iter().all(|item| self.holds(wanted, item))),
            "pattern" => value.as_str().is_none_or(|text| Regex::new(wanted.as_str().unwrap()).unwrap().is_match(text)),
            "required" => value.as_object().is_none_or(|object| {
                wanted.as_array().unwrap().iter().all(|name| object.contains_key(name.as_str().unwrap()))
            }),
            "properties" => value.as_object().is_none_or(|object| {
                let known = object.iter().filter_map(|(name, value)| Some((wanted.get(name)?, value)));
                known.into_iter().all(|(schema, value)| self.holds(schema, value))
            }),
            "patternProperties" => value.as_object().is_none_or(|object| {
                let matching = object.iter().filter_map(|(name, value)| Some((patterned(wanted, name)?, value)));
                matching.into_iter().all(|(schema, value)| self.holds(schema, value))
            }),
            "additionalProperties" if *wanted == Value::Bool(false) => value.as_object().is_none_or(|object| {
                let known = |name: &str| schema.get("properties").is_some_and(|all| all.get(name).is_some());
                let free =
                    |name: &str| schema.get("patternProperties").is_some_and(|all| patterned(all, name).is_some());
                object.keys().all(|name| known(name) || free(name))
            }),
            "anyOf" => holding() > 0,
            "oneOf" => holding() == 1,
            other => panic!("the keyword {other} is not known here"),
        }
    }
}

/// The schema of the first pattern that the name matches.
fn patterned<'a>(patterns: &'a Value, name: &str) -> Option<&'a Value> {
    let mut all = patterns.as_object().unwrap().iter();
    all.find(|(pattern, _)| Regex::new(pattern).unwrap().is_match(name)).map(|(_, schema)| schema)
}

fn is_of_type(name: &str, value: &Value) -> bool {
    match name {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "string" => value.is_string(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        "number" => value.is_number(),
        "integer" => value.as_f64().is_some_and(|value| value.fract() == 0.0),
        other => panic!("the type {other} is not known here"),
    }
}

/// The keywords do what they say.
#[test]
fn the_keywords_are_understood() {
    let schema = |text: &str| Schema(serde_json::from_str(text).unwrap());
    for (text, allowed, refused) in [
        (r#"{"type":"integer","minimum":1}"#, &["1", "2.0"][..], &["0", "1.5", "\"1\""][..]),
        (r#"{"exclusiveMinimum":0,"exclusiveMaximum":1}"#, &["0.5", "[]"], &["0", "1"]),
        (
            r#"{"type":"array","items":{"type":"number"},"minItems":1,"maxItems":2}"#,
            &["[1]"],
            &["[]", "[1,2,3]", "[null]"],
        ),
        (r#"{"type":"string","pattern":"^0x[0-9]+$"}"#, &["\"0x1\""], &["\"1\"", "1"]),
        (
            r#"{"type":"object","properties":{"a":{"const":1}},"required":["a"],"patternProperties":{"^x-":{}},"additionalProperties":false}"#,
            &[r#"{"a":1}"#, r#"{"a":1,"x-b":2}"#],
            &["{}", r#"{"a":2}"#, r#"{"a":1,"b":2}"#],
        ),
        (r##"{"$ref":"#/$defs/a","$defs":{"a":{"enum":["u","v"]}}}"##, &["\"u\""], &["\"w\""]),
        (r#"{"oneOf":[{"type":"number"},{"type":"integer"}]}"#, &["0.5"], &["1", "null"]),
        (r#"{"anyOf":[{"type":"number"},{"type":"null"}]}"#, &["1", "null"], &["true"]),
    ] {
        for value in allowed {
            assert!(schema(text).allows(value), "{text} {value}");
        }
        for value in refused {
            assert!(!schema(text).allows(value), "{text} {value}");
        }
    }
}
