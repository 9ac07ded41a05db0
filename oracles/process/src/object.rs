//! An object that an engine sends. A field that the protocol does not know is an error, unless its name starts with `x-`; so is a field given twice.

use std::fmt::Display;

use serde::de::Error;

/// How the message of an unknown field starts: the verdict is told by it.
pub const UNKNOWN: &str = "unknown field";

/// How the message of a field given twice starts.
pub const TWICE: &str = "field given twice";

/// The error of a field that the protocol does not know.
pub fn unknown<E: Error>(name: &str, known: &[&str]) -> E {
    let name: String = name.chars().take(60).collect();
    E::custom(format_args!("{UNKNOWN} {name:?}, the protocol has {}", known.join(", ")))
}

/// The error of a field given twice.
pub fn twice<E: Error>(name: impl Display) -> E {
    E::custom(format_args!("{TWICE}: {name}"))
}

/// Defines an object whose fields may all be missing or null; what has to be there is asked of it later, where it can be said in words.
macro_rules! object {
    ($(#[$about:meta])* $name:ident { $($(#[$what:meta])* $field:ident: $kind:ty,)* }) => {
        $(#[$about])*
        #[derive(Debug, Default)]
        pub struct $name {
            $($(#[$what])* pub $field: Option<$kind>,)*
        }

        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Fields;

                impl<'de> serde::de::Visitor<'de> for Fields {
                    type Value = $name;

                    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                        f.write_str("an object")
                    }

                    fn visit_map<A: serde::de::MapAccess<'de>>(self, mut map: A) -> Result<$name, A::Error> {
                        let mut object = $name::default();
                        let mut seen: Vec<&str> = Vec::new();
                        while let Some(name) = map.next_key::<std::borrow::Cow<'de, str>>()? {
                            match name.as_ref() {
                                $(stringify!($field) => {
                                    if seen.contains(&stringify!($field)) {
                                        return Err($crate::object::twice(stringify!($field)));
                                    }
                                    seen.push(stringify!($field));
                                    object.$field = map.next_value()?;
                                })*
                                free if free.starts_with("x-") => {
                                    map.next_value::<serde::de::IgnoredAny>()?;
                                }
                                other => return Err($crate::object::unknown(other, &[$(stringify!($field)),*])),
                            }
                        }
                        Ok(object)
                    }
                }

                deserializer.deserialize_map(Fields)
            }
        }
    };
}

pub(crate) use object;
