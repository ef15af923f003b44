//! How an event vocabulary is written down: a table of variants, from which names, fields and their
//! values follow. Slides, listings and questions refer to events by these names.

/// Declares an enum of events with, for each variant, the names it can go by and its fields.
macro_rules! vocabulary {
    (
        $(#[$about:meta])*
        pub enum $Name:ident {
            $( $(#[$doc:meta])* $Variant:ident $names:tt { $( $(#[$field_doc:meta])* $field:ident : $Type:ty ),* $(,)? } )*
        }
    ) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[allow(missing_docs, reason = "the variant's text names its fields")]
        pub enum $Name {
            $( $(#[$doc])* $Variant { $( $(#[$field_doc])* $field: $Type ),* }, )*
        }

        impl $Name {
            /// Every name an event can go by, with the names of its fields.
            pub const NAMES: &'static [(&'static [&'static str], &'static [&'static str])] =
                &[ $( (&$names, &[ $( stringify!($field) ),* ]), )* ];

            /// The value of the field called `name`.
            pub fn field(&self, name: &str) -> Option<$crate::Value> {
                match self {
                    $( $Name::$Variant { $( $field ),* } => {
                        $( if name == stringify!($field) { return Some($crate::Value::from(*$field)); } )*
                        None
                    } )*
                }
            }

            /// The names of this event's fields, in order.
            pub fn fields(&self) -> &'static [&'static str] {
                match self {
                    $( $Name::$Variant { .. } => &[ $( stringify!($field) ),* ], )*
                }
            }
        }
    };
}

/// Declares an enum of words with their spelling, usable as a field of an event.
macro_rules! words {
    ( $( $(#[$about:meta])* pub enum $Name:ident { $( $(#[$doc:meta])* $Variant:ident = $word:literal ),* $(,)? } )* ) => { $(
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $Name { $( $(#[$doc])* $Variant ),* }

        impl $Name {
            /// All the words, in order.
            pub const WORDS: &'static [&'static str] = &[ $( $word ),* ];

            /// All of them, in order.
            pub const ALL: &'static [$Name] = &[ $( $Name::$Variant ),* ];

            /// This one's word.
            pub fn word(self) -> &'static str {
                Self::WORDS[self as usize]
            }
        }

        impl From<$Name> for $crate::Value {
            fn from(value: $Name) -> $crate::Value {
                $crate::Value::Word(value.word(), $Name::WORDS)
            }
        }
    )* };
}

pub(crate) use {vocabulary, words};
