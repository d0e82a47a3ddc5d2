//! Sentences for people, in English and in Brazilian Portuguese.
//!
//! The English sentence stands in the code. Its translation is a message in a `.ftl` file (Fluent) whose
//! identifier is made from the English words by [`key`]; a test demands that none is missing.

use std::{borrow::Cow, collections::HashMap, sync::OnceLock};

use dalembert_units::{self as units, Decimal, Style};
use fluent_bundle::{FluentArgs, FluentResource, concurrent::FluentBundle};
use unic_langid::LanguageIdentifier;

/// A sentence, perhaps with `{names}` of arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// The English sentence.
    pub template: Cow<'static, str>,
    /// What stands in it.
    pub args: Vec<(&'static str, Arg)>,
}

/// What may stand in a sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum Arg {
    /// As it is: names, values as they were typed.
    Verbatim(String),
    /// A sentence of its own.
    Text(Text),
    /// A number in SI, shown in this unit.
    Quantity(f64, &'static str),
}

/// The language of sentences.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Language {
    /// English, with a decimal point.
    #[default]
    English,
    /// Brazilian Portuguese, with a decimal comma.
    Portuguese,
}

/// How things are written for a person: language and style of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Locale {
    /// The language of sentences.
    pub language: Language,
    /// Digits, decimal mark, ASCII or not.
    pub style: Style,
}

/// The Portuguese messages of one crate; collected from every linked crate.
#[derive(Debug)]
pub struct Messages {
    /// The crate, for error messages.
    pub of: &'static str,
    /// The content of its `pt-BR.ftl`.
    pub portuguese: &'static str,
}

inventory::collect!(Messages);

/// A line of a translation file, and the message that it holds once somebody has asked for it: behind a pointer, or the
/// table of all lines would take megabytes of memory that nobody looks at.
type Line = (&'static str, OnceLock<Box<FluentBundle<FluentResource>>>);

/// Registers the translations of a crate: `messages!("../locales/pt-BR.ftl");`
#[macro_export]
macro_rules! messages {
    ($path:literal) => {
        $crate::inventory::submit! {
            $crate::Messages { of: env!("CARGO_PKG_NAME"), portuguese: include_str!($path) }
        }
    };
}

impl Text {
    /// A sentence without arguments yet.
    pub fn new(template: impl Into<Cow<'static, str>>) -> Self {
        Self { template: template.into(), args: Vec::new() }
    }

    /// Words that are the same in every language: what a person typed.
    pub fn verbatim(words: impl std::fmt::Display) -> Self {
        Self::new("{words}").with("words", words)
    }

    /// Whether it says nothing.
    pub fn is_empty(&self) -> bool {
        self.template.is_empty()
    }

    /// The same sentence with `{name}` standing for a text as it is.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: impl std::fmt::Display) -> Self {
        self.args.push((name, Arg::Verbatim(value.to_string())));
        self
    }

    /// The same sentence with `{name}` standing for another sentence.
    #[must_use]
    pub fn with_text(mut self, name: &'static str, text: impl Into<Text>) -> Self {
        self.args.push((name, Arg::Text(text.into())));
        self
    }

    /// The same sentence with `{name}` standing for a number in SI, shown in `unit`.
    #[must_use]
    pub fn with_quantity(mut self, name: &'static str, si: f64, unit: &'static str) -> Self {
        self.args.push((name, Arg::Quantity(si, unit)));
        self
    }

    /// The sentence as a person reads it. English where the language lacks it.
    pub fn render(&self, locale: &Locale) -> String {
        if self.is_empty() {
            return String::new();
        }
        let args: Vec<(&str, String)> =
            self.args.iter().map(|(name, arg)| (*name, arg.render(locale))).collect();
        let translated = match locale.language {
            Language::English => None,
            // Sentences that differ by their first letter alone have one translation.
            Language::Portuguese => portuguese(&self.template, &args)
                .map(|text| if self.template.starts_with(char::is_uppercase) { capital(text) } else { text }),
        };
        let text = translated.unwrap_or_else(|| {
            args.iter().fold(self.template.to_string(), |text, (name, value)| {
                text.replace(&format!("{{{name}}}"), value)
            })
        });
        // Names take more cells than letters: they have to stand here before anything is laid out.
        if locale.style.ascii { crate::ascii(&text) } else { text }
    }

    /// The same sentence with a question mark for every number.
    #[must_use]
    pub fn without_numbers(&self) -> Self {
        let covered = |arg: &Arg| match arg {
            Arg::Verbatim(text) => Arg::Verbatim(text.clone()),
            Arg::Text(text) => Arg::Text(text.without_numbers()),
            Arg::Quantity(..) => Arg::Verbatim("?".to_owned()),
        };
        let args = self.args.iter().map(|(name, arg)| (*name, covered(arg))).collect();
        Self { template: self.template.clone(), args }
    }

    /// The sentence in English.
    pub fn english(&self) -> String {
        self.render(&Locale::default())
    }
}

impl Arg {
    fn render(&self, locale: &Locale) -> String {
        match self {
            Arg::Verbatim(text) => text.clone(),
            Arg::Text(text) => text.render(locale),
            Arg::Quantity(si, unit) => match units::unit(unit) {
                Ok(unit) => units::write_quantity(*si, &unit, locale.style),
                Err(_) => si.to_string(),
            },
        }
    }
}

impl From<&'static str> for Text {
    fn from(template: &'static str) -> Self {
        Text::new(template)
    }
}

impl Locale {
    /// English with a decimal point, five digits.
    pub fn english() -> Self {
        Self { language: Language::English, style: Style::default() }
    }

    /// Brazilian Portuguese with a decimal comma, five digits.
    pub fn portuguese() -> Self {
        Self { language: Language::Portuguese, style: Style { decimal: Decimal::Comma, ..Style::default() } }
    }

    /// The same locale with so many significant digits.
    #[must_use]
    pub fn digits(mut self, digits: u8) -> Self {
        self.style.digits = digits;
        self
    }

    /// The same locale for a screen that shows nothing outside ASCII, or for one that does.
    #[must_use]
    pub fn ascii(mut self, ascii: bool) -> Self {
        self.style.ascii = ascii;
        self
    }
}

impl Default for Locale {
    fn default() -> Self {
        Self::english()
    }
}

impl Language {
    /// The language that a name such as `pt_BR.UTF-8` asks for.
    pub fn of(name: &str) -> Self {
        if name.to_ascii_lowercase().starts_with("pt") { Language::Portuguese } else { Language::English }
    }
}

/// The identifier of a sentence's translation: its words in lower case, joined by `-`.
///
/// `"ΣM = 0 about {plane}"` gives `m-0-about-plane`; more than 100 characters are cut at a word.
pub fn key(template: &str) -> String {
    let mut key = String::new();
    for word in template.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()) {
        if key.len() + word.len() > 100 {
            break;
        }
        if key.is_empty() && !word.starts_with(|c: char| c.is_ascii_alphabetic()) {
            key += "n";
        }
        if !key.is_empty() {
            key.push('-');
        }
        key += &word.to_ascii_lowercase();
    }
    key
}

fn capital(text: String) -> String {
    match text.chars().next().filter(|first| first.is_lowercase()) {
        Some(first) => first.to_uppercase().chain(text.chars().skip(1)).collect(),
        None => text,
    }
}

/// Whether the sentence has a translation.
pub fn is_translated(template: &str) -> bool {
    let key = key(template);
    bundle(&key)
        .is_some_and(|bundle| bundle.get_message(&key).is_some_and(|message| message.value().is_some()))
}

/// Faults of the translation files: what does not parse, and keys that stand twice with different words.
pub fn translation_faults() -> Vec<String> {
    let mut faults = Vec::new();
    let mut seen: HashMap<String, (String, &str)> = HashMap::new();
    for messages in inventory::iter::<Messages>() {
        if let Err((_, errors)) = FluentResource::try_new(messages.portuguese.to_owned()) {
            faults.extend(errors.iter().map(|err| format!("{}: {err}", messages.of)));
        }
        for line in messages.portuguese.lines() {
            let Some((id, words)) = line.split_once(" = ") else { continue };
            match seen.get(id) {
                Some((other, of)) if other != words => {
                    faults.push(format!("{id} stands in {} and in {of} with other words", messages.of));
                }
                Some((_, of)) if *of == messages.of => faults.push(format!("{id} stands twice in {of}")),
                _ => {
                    seen.insert(id.to_owned(), (words.to_owned(), messages.of));
                }
            }
        }
    }
    faults
}

fn portuguese(template: &str, args: &[(&str, String)]) -> Option<String> {
    let key = key(template);
    let bundle = bundle(&key)?;
    let message = bundle.get_message(&key)?;
    let mut fluent = FluentArgs::new();
    for (name, value) in args {
        fluent.set(*name, value.as_str());
    }
    let mut errors = Vec::new();
    let text = bundle.format_pattern(message.value()?, Some(&fluent), &mut errors);
    errors.is_empty().then(|| text.into_owned())
}

/// The message of a key, read when it is first asked for: to read all of them takes longer than to begin a session.
fn bundle(key: &str) -> Option<&'static FluentBundle<FluentResource>> {
    let (line, bundle) = catalogue().get(key)?;
    Some(bundle.get_or_init(|| {
        let portuguese = LanguageIdentifier::from_bytes(b"pt-BR").expect("pt-BR names a language");
        let mut bundle = FluentBundle::new_concurrent(vec![portuguese]);
        // Isolation marks round every argument would break the widths of terminal cells.
        bundle.set_use_isolating(false);
        // A faulty line serves nobody; it fails a test.
        let (Ok(resource) | Err((resource, _))) = FluentResource::try_new((*line).to_owned());
        bundle.add_resource_overriding(resource);
        Box::new(bundle)
    }))
}

/// The lines of all translation files by their keys: a message is a line.
fn catalogue() -> &'static HashMap<&'static str, Line> {
    static CATALOGUE: OnceLock<HashMap<&str, Line>> = OnceLock::new();
    CATALOGUE.get_or_init(|| {
        let lines = inventory::iter::<Messages>().flat_map(|messages| messages.portuguese.lines());
        lines.filter_map(|line| Some((line.split_once(" = ")?.0, (line, OnceLock::new())))).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_made_of_words() {
        assert_eq!(key("Natural frequency without damping"), "natural-frequency-without-damping");
        assert_eq!(key("ΣM = 0 about {plane}"), "m-0-about-plane");
        assert_eq!(key("2 planes coincide"), "n-2-planes-coincide");
        assert!(key(&"word ".repeat(40)).len() <= 100);
    }

    #[test]
    fn arguments_stand_where_they_are_named() {
        let text = Text::new("{a} is above {b}").with("a", "3 kg").with_quantity("b", 0.0025, "mm");
        assert_eq!(text.english(), "3 kg is above 2.5 mm");
        assert_eq!(text.render(&Locale::portuguese()), "3 kg is above 2,5 mm");
    }

    #[test]
    fn in_ascii_no_greek_letter_is_a_latin_one() {
        let text = Text::verbatim("Λₘₐₓ beside L, §1.7, ω and w");
        let ascii = Locale::english().ascii(true);
        assert_eq!(text.render(&ascii), "Lambda_max beside L, sec. 1.7, omega and w");
    }
}
