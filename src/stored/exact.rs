//! JSON that gives back every double: the finite ones as shortest decimals, the others, for which JSON has no numbers, as `{"#f64":"nan"}`, `{"#f64":"inf"}`
//! and `{"#f64":"-inf"}`. A whole number as the key of a map is `"#7"`; a text as a key that begins so has one `#` more.

use ciborium::Value;
use serde::{Serialize, de::DeserializeOwned};
use serde_json::Value as Json;

/// The key of a double that JSON has no number for.
const KEY: &str = "#f64";

/// Those doubles, and what they are called.
const NAMED: [(&str, f64); 3] = [("nan", f64::NAN), ("inf", f64::INFINITY), ("-inf", f64::NEG_INFINITY)];

/// A value as one line of JSON.
///
/// # Errors
/// When it has something that JSON has no form for, such as a map whose keys are neither texts nor whole numbers.
pub fn to_line(value: &impl Serialize) -> Result<String, String> {
    let value = Value::serialized(value).map_err(|error| error.to_string())?;
    Ok(json(value)?.to_string())
}

/// The value of a line.
///
/// # Errors
/// When the line is not JSON, or not of that type.
pub fn from_line<T: DeserializeOwned>(line: &str) -> Result<T, String> {
    let json: Json = serde_json::from_str(line).map_err(|error| error.to_string())?;
    value(json).deserialized().map_err(|error| error.to_string())
}

fn json(value: Value) -> Result<Json, String> {
    Ok(match value {
        Value::Null => Json::Null,
        Value::Bool(truth) => Json::Bool(truth),
        Value::Text(text) => Json::String(text),
        Value::Integer(whole) => {
            let whole = serde_json::Number::from_i128(whole.into()).ok_or("a whole number of more than 64 bits")?;
            Json::Number(whole)
        }
        Value::Float(number) => match serde_json::Number::from_f64(number) {
            Some(number) => Json::Number(number),
            None => {
                let is_it = |(_, other): &&(&str, f64)| other.total_cmp(&number).is_eq() || number.is_nan();
                let name = NAMED.iter().find(is_it).map_or("nan", |(name, _)| name);
                Json::Object([(KEY.to_owned(), Json::from(name))].into_iter().collect())
            }
        },
        Value::Array(items) => Json::Array(items.into_iter().map(json).collect::<Result<_, _>>()?),
        Value::Map(entries) => {
            let entry = |(key, value)| match key {
                Value::Text(key) if key.starts_with('#') => Ok((format!("#{key}"), json(value)?)),
                Value::Text(key) => Ok((key, json(value)?)),
                Value::Integer(key) => Ok((format!("#{}", i128::from(key)), json(value)?)),
                other => Err(format!("{other:?} as the key of a map")),
            };
            Json::Object(entries.into_iter().map(entry).collect::<Result<_, _>>()?)
        }
        other => return Err(format!("{other:?}, for which JSON has no form")),
    })
}

fn value(json: Json) -> Value {
    match json {
        Json::Null => Value::Null,
        Json::Bool(truth) => Value::Bool(truth),
        Json::String(text) => Value::Text(text),
        Json::Number(number) => match (number.as_u64(), number.as_i64()) {
            (Some(whole), _) => Value::from(whole),
            (None, Some(whole)) => Value::from(whole),
            (None, None) => Value::Float(number.as_f64().unwrap_or(f64::NAN)),
        },
        Json::Array(items) => Value::Array(items.into_iter().map(value).collect()),
        Json::Object(entries) => {
            let only = (entries.len() == 1).then(|| entries.get(KEY).and_then(Json::as_str)).flatten();
            let named = only.and_then(|name| NAMED.iter().find(|(known, _)| *known == name));
            if let Some((_, number)) = named {
                return Value::Float(*number);
            }
            Value::Map(entries.into_iter().map(|(name, entry)| (key(&name), value(entry))).collect())
        }
    }
}

/// A key as it was before it was written.
fn key(written: &str) -> Value {
    let Some(rest) = written.strip_prefix('#') else { return Value::Text(written.to_owned()) };
    let whole = || rest.parse::<u64>().map(Value::from).or_else(|_| rest.parse::<i64>().map(Value::from));
    whole().unwrap_or_else(|_| Value::Text(rest.to_owned()))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use proptest::prelude::*;
    use serde::Deserialize;

    use super::*;

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    enum Kind {
        Plain,
        Of(f64),
        Pair(f64, u8),
        Named { value: f64 },
    }

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct Inner {
        number: f64,
        whole: u64,
    }

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct Everything {
        #[serde(flatten)]
        inner: Inner,
        least: i64,
        maybe: Option<f64>,
        no: Option<f64>,
        pair: (f64, f64),
        kinds: Vec<Kind>,
        map: BTreeMap<String, f64>,
        classes: BTreeMap<i64, usize>,
        hashes: BTreeMap<u64, usize>,
    }

    #[test]
    fn everything_comes_back() {
        let everything = Everything {
            inner: Inner { number: -0.0, whole: u64::MAX },
            least: i64::MIN,
            maybe: Some(f64::INFINITY),
            no: None,
            pair: (3.0, f64::NEG_INFINITY),
            kinds: vec![Kind::Plain, Kind::Of(0.1), Kind::Pair(1e300, 7), Kind::Named { value: 5e-324 }],
            map: ["f64", "#f64", "#7", "##", "7", ""].map(|key| (key.to_owned(), 1.0)).into(),
            classes: [(i64::MIN, 1), (-3, 2)].into(),
            hashes: [(u64::MAX, 1)].into(),
        };
        let line = to_line(&everything).unwrap();
        let back: Everything = from_line(&line).unwrap();
        assert_eq!(back, everything);
        assert!(back.inner.number.is_sign_negative() && !line.contains('\n'), "{line}");
        assert!(from_line::<f64>(&to_line(&f64::NAN).unwrap()).unwrap().is_nan());
        assert_eq!(to_line(&f64::NAN).unwrap(), r##"{"#f64":"nan"}"##);
        let only = BTreeMap::from([("#f64".to_owned(), "inf".to_owned())]);
        assert_eq!(from_line::<BTreeMap<String, String>>(&to_line(&only).unwrap()).unwrap(), only);
        assert!(to_line(&BTreeMap::from([((1, 2), 3)])).unwrap_err().contains("key"));
        assert!(from_line::<f64>("\"x\"").is_err() && from_line::<f64>("{").is_err());
    }

    proptest! {
        #[test]
        fn every_double_comes_back_to_the_last_bit(bits in any::<u64>()) {
            let number = f64::from_bits(bits);
            let back: f64 = from_line(&to_line(&number).unwrap()).unwrap();
            prop_assert!(back.to_bits() == bits || back.is_nan() && number.is_nan());
        }
    }
}
