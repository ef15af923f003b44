//! Which structure is built: its kind, and what of it differs from the usual.

use raystep_accel::Rule;

use crate::keys::{At, Keys};
use crate::reading::Reading;
use crate::{Numbers, Spot, template};

/// Which structure to build: its kind and its parameters as the slide writes them.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// `"slab"`, or one of the kinds of structures that answer rays.
    pub kind: String,
    /// Its parameters, those that differ from the usual ones.
    pub settings: Vec<Setting>,
    /// Where the kind stands.
    pub(crate) spot: Spot,
}

impl Plan {
    /// `{ kind = "kd", max_depth = 6 }`
    pub(crate) fn read(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<Plan> {
        let kind = keys.need::<String>("kind", reading);
        keys.say_missing(reading);
        let ((at, kind), rest) = (kind?, keys.rest(reading));
        let setting = |((at, key), value): (At<String>, String)| Setting { key, value, spot: reading.spot(at) };
        Some(Plan { kind, settings: rest.into_iter().map(setting).collect(), spot: reading.spot(at) })
    }

    /// Every parameter that cannot be, or the kind, with where it stands and a sentence.
    pub(crate) fn wrong(&self) -> Vec<(Spot, String)> {
        match Rule::default_for(&self.kind) {
            Ok(mut rule) => {
                let set = |setting: &Setting| {
                    rule.set(&setting.key, &setting.value).err().map(|why| (setting.spot, why.to_string()))
                };
                self.settings.iter().filter_map(set).collect()
            }
            Err(why) => vec![(self.spot, why.to_string())],
        }
    }

    /// What a slide would write for a rule over a scene that is flat or not.
    pub(crate) fn of(rule: &Rule, flat: bool) -> Plan {
        let usual = Rule::default_for(rule.kind()).map(|usual| if flat { usual.flat() } else { usual });
        let differs = usual.map(|usual| rule.differences(&usual)).unwrap_or_default();
        let spot = Spot::default();
        let setting = |(key, value): (&'static str, String)| Setting { key: key.to_owned(), value, spot };
        Plan { kind: rule.kind().to_owned(), settings: differs.into_iter().map(setting).collect(), spot }
    }

    /// Whether a parameter is a number of a meter, as in `max_depth = "{{depth}}"`.
    pub fn is_moved(&self) -> bool {
        self.settings.iter().any(|setting| template::named(&setting.value).next().is_some())
    }

    /// The plan where the numbers of a meter stand.
    #[must_use]
    pub fn at(&self, numbers: &Numbers) -> Plan {
        let mut plan = self.clone();
        for setting in &mut plan.settings {
            let names: Vec<String> = template::named(&setting.value).map(str::to_owned).collect();
            for name in names {
                let number = numbers.get(&name).unwrap_or(f64::NAN);
                setting.value = setting.value.replace(&format!("{{{{{name}}}}}"), &number.to_string());
            }
        }
        plan
    }

    /// No structure: every primitive is tested.
    pub(crate) fn all() -> Plan {
        Plan { kind: "list".to_owned(), settings: Vec::new(), spot: Spot::default() }
    }

    /// A hierarchy of boxes as it usually is.
    pub(crate) fn boxes() -> Plan {
        Plan { kind: "bvh".to_owned(), ..Plan::all() }
    }
}

/// One parameter of a structure.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// Its key.
    pub key: String,
    /// Its value as text.
    pub value: String,
    /// Where the key stands.
    pub(crate) spot: Spot,
}
