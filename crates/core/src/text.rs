//! Messages and their translation: English sentences as keys, Brazilian Portuguese beside them.
//!
//! The English sentence stands in the code. Its translation is a message in a `.ftl` file (Fluent) whose
//! identifier is made from the English words by [`key`]; a test demands that none is missing.
//!
//! A sentence is translated for the place where it is shown ([`Locale::place`]): first by the attribute named after
//! the analysis, then by the message of its family, then by that of any other crate.
//!
//! ```text
//! largest-speed = Velocidade máxima
//!     .flywheel = Rotação máxima
//! ```

use std::{borrow::Cow, collections::HashMap, sync::OnceLock};

use dalembert_units::{self as units, Decimal, Style, UnitSystem};
use fluent_bundle::{FluentArgs, FluentResource, concurrent::FluentBundle};
use unic_langid::LanguageIdentifier;

use crate::unit_system;

/// A sentence, perhaps with `{names}` of arguments.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Text {
    /// The English sentence.
    pub template: Cow<'static, str>,
    /// Arguments, by the names of their placeholders.
    pub args: Vec<(&'static str, Arg)>,
}

/// Argument of a sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum Arg {
    /// As it is: names, values as they were typed.
    Verbatim(String),
    /// A sentence of its own.
    Text(Text),
    /// A number in SI, shown in this unit.
    Quantity(f64, &'static str),
    /// A number as it is written with a decimal point, shown with the decimal mark of the reader.
    Number(String),
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

/// Conventions of a user: language, style of numbers, and the context of translations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Locale {
    /// The language of sentences.
    pub language: Language,
    /// Digits, decimal mark, ASCII or not.
    pub style: Style,
    /// The analysis whose sentences are shown, by its id, such as `vibration/flywheel`; empty outside of any.
    pub place: &'static str,
}

/// The Portuguese messages of one crate; collected from every linked crate.
#[derive(Debug)]
pub struct Messages {
    /// The crate; that of a family is named `dalembert-` and the family.
    pub of: &'static str,
    /// The content of its `pt-BR.ftl`.
    pub portuguese: &'static str,
}

inventory::collect!(Messages);

/// A message of a translation file with its attributes, parsed when it is first needed: parsing all of them takes
/// longer than to begin a session. The parsed message is boxed to keep the table small.
struct Message {
    /// The family of the crate, or the crate where it is of no family.
    of: &'static str,
    source: &'static str,
    parsed: OnceLock<Box<FluentBundle<FluentResource>>>,
}

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

    /// Words that are the same in every language: what a user typed.
    pub fn verbatim(words: impl std::fmt::Display) -> Self {
        // No sentence has this key: `{words}` is that of the word "words".
        Self::new("{verbatim}").with("verbatim", words)
    }

    /// Returns true if the text is empty.
    pub fn is_empty(&self) -> bool {
        self.template.is_empty()
    }

    /// The same sentence with `{name}` standing for a text as it is.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: impl std::fmt::Display) -> Self {
        self.args.push((name, Arg::Verbatim(value.to_string())));
        self
    }

    /// The same sentence with `{name}` standing for a number as it is written with a decimal point.
    #[must_use]
    pub fn with_number(mut self, name: &'static str, written: impl std::fmt::Display) -> Self {
        self.args.push((name, Arg::Number(written.to_string())));
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

    /// A number in SI alone, shown in `unit`.
    pub fn quantity(si: f64, unit: &'static str) -> Self {
        Text::new("{shown_quantity}").with_quantity("shown_quantity", si, unit)
    }

    /// The sentence as a user reads it. English where the language lacks it.
    pub fn render(&self, locale: &Locale) -> String {
        if self.is_empty() {
            return String::new();
        }
        let args: Vec<(&str, String)> =
            self.args.iter().map(|(name, arg)| (*name, arg.render(locale))).collect();
        let translated = match locale.language {
            Language::English => None,
            // Sentences that differ by their first letter alone have one translation.
            Language::Portuguese => portuguese(locale.place, &self.template, &args)
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
            Arg::Number(written) => Arg::Number(written.clone()),
            Arg::Text(text) => Arg::Text(text.without_numbers()),
            Arg::Quantity(..) => Arg::Verbatim("?".to_owned()),
        };
        let args = self.args.iter().map(|(name, arg)| (*name, covered(arg))).collect();
        Self { template: self.template.clone(), args }
    }

    /// Shows every number of the sentence in the unit of a system.
    pub(crate) fn show_in(&mut self, system: UnitSystem) {
        for (_, arg) in &mut self.args {
            match arg {
                Arg::Verbatim(_) | Arg::Number(_) => {}
                Arg::Text(text) => text.show_in(system),
                Arg::Quantity(_, unit) => *unit = unit_system::of_text(unit, system),
            }
        }
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
            Arg::Number(written) => locale.style.decimal.written(written),
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

/// A sentence that is made only if somebody reads it.
impl<F: FnOnce() -> Text> From<F> for Text {
    fn from(sentence: F) -> Self {
        sentence()
    }
}

impl Locale {
    /// Locale of a language.
    pub fn of(language: Language) -> Self {
        match language {
            Language::English => Self::english(),
            Language::Portuguese => Self::portuguese(),
        }
    }

    /// English with a decimal point, five digits.
    pub fn english() -> Self {
        Self { language: Language::English, style: Style::default(), place: "" }
    }

    /// Brazilian Portuguese with a decimal comma, five digits.
    pub fn portuguese() -> Self {
        let style = Style { decimal: Decimal::Comma, ..Style::default() };
        Self { language: Language::Portuguese, style, place: "" }
    }

    /// The same locale for the sentences of an analysis, given by its id.
    #[must_use]
    pub fn at(mut self, place: &'static str) -> Self {
        self.place = place;
        self
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
    /// Every language.
    pub const ALL: [Self; 2] = [Self::English, Self::Portuguese];

    /// The language after this one, in a circle.
    #[must_use]
    pub fn next(self) -> Self {
        let after = Self::ALL.into_iter().skip_while(|language| *language != self).nth(1);
        after.unwrap_or(Self::ALL[0])
    }

    /// Tag of the language (BCP 47): `en`, `pt-BR`.
    pub const fn tag(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::Portuguese => "pt-BR",
        }
    }

    /// Language of a tag.
    pub fn of_tag(tag: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|language| language.tag() == tag)
    }

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

/// Returns true if a sentence has neither a word of a language nor a number, whose decimal mark is of one: symbols, with
/// subscripts of two letters, signs, and what stands in a place. Their keys leave out the signs that tell them apart:
/// `{a} ≤ {b}` has that of `{a} ≥ {b}`.
pub fn is_notation(template: &str) -> bool {
    let (mut in_place, mut letters, mut before) = (false, 0, ' ');
    for c in template.chars() {
        match c {
            '{' => in_place = true,
            '}' => in_place = false,
            _ if in_place => {}
            _ if c.is_ascii_digit() => return false,
            _ if c.is_ascii_alphabetic() => {
                // The subscript of a symbol may have one letter more.
                letters = if letters == 0 && before == '_' { 0 } else { letters + 1 };
                if letters == 2 {
                    return false;
                }
            }
            _ => letters = 0,
        }
        before = c;
    }
    true
}

fn capital(text: String) -> String {
    match text.chars().next().filter(|first| first.is_lowercase()) {
        Some(first) => first.to_uppercase().chain(text.chars().skip(1)).collect(),
        None => text,
    }
}

/// Returns true if the sentence has a translation.
pub fn is_translated(template: &str) -> bool {
    let key = key(template);
    message("", &key).is_some_and(|message| {
        message.bundle().get_message(&key).is_some_and(|found| found.value().is_some())
    })
}

/// Faults of the translation files: what does not parse, keys that stand twice in a file, attributes that name no
/// analysis of the family, and sentences that the program and a family translate differently.
pub fn translation_faults() -> Vec<String> {
    let mut faults = Vec::new();
    for messages in inventory::iter::<Messages>() {
        if let Err((_, errors)) = FluentResource::try_new(messages.portuguese.to_owned()) {
            faults.extend(errors.iter().map(|err| format!("{}: {err}", messages.of)));
        }
    }
    for (key, messages) in catalogue() {
        for (n, message) in messages.iter().enumerate() {
            let of = message.of;
            if messages[..n].iter().any(|other| other.of == of) {
                faults.push(format!("{key} appears twice in {of}"));
            }
            // The program's own sentences are shown beside those of every analysis.
            let first = &messages[0];
            if !is_family(first.of) && first.words() != message.words() {
                faults.push(format!("{key} appears in {} and in {of} with other words", first.of));
            }
            for (name, _) in message.attributes() {
                if !crate::registry().iter().any(|entry| entry.about.id == format!("{of}/{name}")) {
                    faults.push(format!("{key} in {of} has words for `{name}`, which is not an analysis"));
                }
            }
        }
    }
    faults.sort();
    faults
}

fn portuguese(place: &str, template: &str, args: &[(&str, String)]) -> Option<String> {
    if is_notation(template) {
        return None;
    }
    let key = key(template);
    let (family, analysis) = place.split_once('/').unwrap_or_default();
    let message = message(family, &key)?;
    let bundle = message.bundle();
    let found = bundle.get_message(&key)?;
    let of_analysis = found.get_attribute(analysis).filter(|_| message.of == family);
    let pattern = of_analysis.map(|attribute| attribute.value()).or_else(|| found.value())?;
    let mut fluent = FluentArgs::new();
    for (name, value) in args {
        fluent.set(*name, value.as_str());
    }
    let mut errors = Vec::new();
    let text = bundle.format_pattern(pattern, Some(&fluent), &mut errors);
    errors.is_empty().then(|| text.into_owned())
}

/// The message of a key, that of the family if it has one.
fn message(family: &str, key: &str) -> Option<&'static Message> {
    let messages = catalogue().get(key)?;
    messages.iter().find(|message| message.of == family).or_else(|| messages.first())
}

fn is_family(of: &str) -> bool {
    crate::registry().iter().any(|entry| entry.family() == of)
}

impl Message {
    fn words(&self) -> &str {
        let first = self.source.lines().next().unwrap_or_default();
        first.split_once(" = ").map_or("", |(_, words)| words)
    }

    /// The analyses that have words of their own, and these.
    fn attributes(&self) -> impl Iterator<Item = (&str, &str)> {
        self.source.lines().skip(1).filter_map(|line| line.trim_start().strip_prefix('.')?.split_once(" = "))
    }

    fn bundle(&self) -> &FluentBundle<FluentResource> {
        self.parsed.get_or_init(|| {
            let portuguese = LanguageIdentifier::from_bytes(b"pt-BR").expect("pt-BR names a language");
            let mut bundle = FluentBundle::new_concurrent(vec![portuguese]);
            // Isolation marks round every argument would break the widths of terminal cells.
            bundle.set_use_isolating(false);
            // A test reports what does not parse.
            let (Ok(resource) | Err((resource, _))) = FluentResource::try_new(self.source.to_owned());
            bundle.add_resource_overriding(resource);
            Box::new(bundle)
        })
    }
}

/// The messages of all translation files by their keys, those of the program before those of families.
fn catalogue() -> &'static HashMap<&'static str, Vec<Message>> {
    static CATALOGUE: OnceLock<HashMap<&str, Vec<Message>>> = OnceLock::new();
    CATALOGUE.get_or_init(|| {
        let mut found: HashMap<&str, Vec<Message>> = HashMap::new();
        for messages in inventory::iter::<Messages>() {
            let of = messages.of.strip_prefix("dalembert-").unwrap_or(messages.of);
            for (key, source) in messages_of(messages.portuguese) {
                found.entry(key).or_default().push(Message { of, source, parsed: OnceLock::new() });
            }
        }
        // Crates are linked in any order.
        for messages in found.values_mut() {
            messages.sort_by_key(|message| (is_family(message.of), message.of));
        }
        found
    })
}

/// The messages of a translation file: the key of each, and its text with its attributes, which are indented.
fn messages_of(file: &'static str) -> impl Iterator<Item = (&'static str, &'static str)> {
    let mut rest = file;
    std::iter::from_fn(move || {
        loop {
            let line = rest.lines().next()?;
            let mut end = 0;
            for (n, line) in rest.split_inclusive('\n').enumerate() {
                if n > 0 && !line.starts_with(' ') {
                    break;
                }
                end += line.len();
            }
            let source = &rest[..end];
            rest = &rest[end..];
            if let Some((key, _)) = line.split_once(" = ").filter(|_| !line.starts_with([' ', '#'])) {
                return Some((key, source));
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_and_relations_are_the_same_in_every_language() {
        for notation in
            ["{answer} ≤ {value}", "{answer} ≥ {value}", "m r", "Σ m r ω²", "M_R", "ω_in", "{n}", ""]
        {
            assert!(is_notation(notation), "{notation}");
            let text = Text::new(notation).with("answer", "x").with("value", "2 m").with("n", 3);
            assert_eq!(text.render(&Locale::portuguese()), text.english());
        }
        for sentence in ["in", "m r of the crank", "speed {n}", "F_max"] {
            assert!(!is_notation(sentence), "{sentence}");
        }
    }

    #[test]
    fn words_of_the_user_are_no_sentence() {
        for locale in [Locale::english(), Locale::portuguese()] {
            assert_eq!(Text::verbatim("Fan on the roof").render(&locale), "Fan on the roof");
        }
    }

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

    inventory::submit! {
        Messages {
            of: "dalembert-family",
            portuguese: "\
## Comments and blank lines

top-speed = Velocidade de ponta
    .wheel = Rotação de ponta
of-wheel-speed = Velocidade { $speed }
",
        }
    }
    inventory::submit! {
        Messages { of: "dalembert-other", portuguese: "top-speed = Velocidade mais alta\n    .wheel = Outra\n" }
    }

    #[test]
    fn a_sentence_is_translated_for_its_place() {
        let at = |place| Text::from("Top speed").render(&Locale::portuguese().at(place));
        assert_eq!(at("family/wheel"), "Rotação de ponta");
        assert_eq!(at("family/axle"), "Velocidade de ponta");
        assert_eq!(at("other/axle"), "Velocidade mais alta");
        assert_eq!(at("third/wheel"), "Velocidade de ponta");
        assert_eq!(at(""), "Velocidade de ponta");
        let of = Text::new("of wheel {speed}").with("speed", "3 m/s");
        assert_eq!(of.render(&Locale::portuguese().at("family/wheel")), "Velocidade 3 m/s");
    }

    #[test]
    fn in_ascii_no_greek_letter_is_a_latin_one() {
        let text = Text::verbatim("Λₘₐₓ beside L, §1.7, ω and w");
        let ascii = Locale::english().ascii(true);
        assert_eq!(text.render(&ascii), "Lambda_max beside L, sec. 1.7, omega and w");
    }
}
