//! Standard streams: capabilities of the terminal, and output to it.

use std::{
    ffi::OsString,
    io::{self, IsTerminal, Write},
    process::ExitCode,
};

use dalembert_core::{Language, Locale, Text, ascii};
use dalembert_report::{Document, json_text, text};
use dalembert_tui::{
    glyphs::{Capabilities, Colors, Environment, Glyphs, filter_untrusted},
    terminal,
};

use crate::failure::Failure;

/// The widest text that is laid out: longer lines are hard to read.
const WIDEST: usize = 100;
/// The width where there is no terminal.
const USUAL: usize = 80;

/// The terminal or file that the program was started on.
#[derive(Clone, Debug)]
pub(crate) struct Console {
    /// Language and numbers.
    pub(crate) locale: Locale,
    /// Columns of a line.
    pub(crate) width: usize,
    /// True if errors may be coloured.
    pub(crate) styled_errors: bool,
    /// Capabilities of the terminal.
    pub(crate) capabilities: Capabilities,
    /// True if input and output are both a terminal.
    pub(crate) interactive: bool,
    /// True if notes are not said: they stand in the result.
    pub(crate) is_quiet: bool,
}

impl Console {
    /// That of this process.
    pub(crate) fn of_process(language: Language, only_ascii: bool) -> Self {
        let capabilities = Capabilities::detect(&Environment::of_process());
        let stdout = io::stdout();
        let mut locale = Locale::of(language);
        locale.style.ascii = only_ascii || (stdout.is_terminal() && capabilities.glyphs == Glyphs::Ascii);
        let width = terminal::columns().map_or(USUAL, |columns| usize::from(columns).min(WIDEST));
        Self {
            locale,
            width,
            styled_errors: io::stderr().is_terminal() && capabilities.colors != Colors::None,
            capabilities,
            interactive: stdout.is_terminal() && io::stdin().is_terminal(),
            is_quiet: false,
        }
    }

    /// That of another program, for which everything stands in the result.
    pub(crate) fn of_program(locale: Locale) -> Self {
        Self {
            locale,
            width: USUAL,
            styled_errors: false,
            capabilities: Capabilities::default(),
            interactive: false,
            is_quiet: true,
        }
    }

    /// Prints a document.
    pub(crate) fn print(&self, document: Document) -> Result<(), Failure> {
        print(&self.written(document))
    }

    /// A document as this console shows it. Names and titles from a file cannot drive the terminal.
    pub(crate) fn written(&self, document: Document) -> String {
        let document = document.map(&|words| self.plain(words));
        text(&document, self.width)
    }

    /// Says something on the error stream beside what is printed: a `note` or a `warning`.
    pub(crate) fn notify(&self, template: &'static str, words: &Text) {
        if self.is_quiet {
            return;
        }
        let line = Text::new(template).with_text("words", words.clone()).render(&self.locale);
        // Nobody is left to read it when the error stream itself is closed.
        let _ = writeln!(io::stderr(), "{}", self.plain(&line).replace('\n', " "));
    }

    /// Words without control characters, and in ASCII where that is all there is.
    pub(crate) fn plain(&self, words: &str) -> String {
        let safe = filter_untrusted(words);
        if self.locale.style.ascii { ascii(&safe) } else { safe.into_owned() }
    }

    /// Reports a failure on the error stream; the exit status that goes with it.
    pub(crate) fn report(&self, failure: &Failure) -> ExitCode {
        let say = |text: Text| self.plain(&text.render(&self.locale));
        let error = |why: String| say(Text::new("error: {why}").with("why", why));
        let (lines, status) = match failure {
            Failure::Input(all) => {
                (all.iter().map(|why| error(why.render(&self.locale))).collect::<Vec<_>>().join("\n"), 2)
            }
            Failure::InFile(errors) => (errors.shown.clone(), 2),
            Failure::File(err) => (error(err.text().render(&self.locale)), 2),
            Failure::Refused(why) => (say(Text::new("no answer: {why}").with_text("why", why.clone())), 1),
            Failure::Unmet(why) => (error(why.render(&self.locale)), 1),
            Failure::Fault(what) => {
                (say(Text::new("internal error, not caused by your input: {what}").with("what", what)), 2)
            }
            Failure::Output(err) => (error(err.to_string()), 2),
        };
        // Nobody is left to read it when the error stream itself is closed.
        let _ = writeln!(io::stderr(), "{lines}");
        ExitCode::from(status)
    }
}

/// Prints a text as it is. A reader that has left is no failure.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(err) if err.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        Err(err) => Err(Failure::Output(err)),
        Ok(()) => Ok(()),
    }
}

/// Prints JSON.
pub(crate) fn print_json(json: &serde_json::Value) -> Result<(), Failure> {
    print(&json_text(json))
}

/// The language of `--lang`, of the user's settings, or of the environment: `LC_ALL`, `LC_MESSAGES`, `LANG`, the
/// first that is set.
pub(crate) fn requested_language(words: &[OsString], settings: Option<Language>) -> Language {
    let mut asked = None;
    let mut words = words.iter().map(|word| word.to_string_lossy()).take_while(|word| word != "--");
    while let Some(word) = words.next() {
        match word.strip_prefix("--lang") {
            Some("") => asked = words.next().map(std::borrow::Cow::into_owned),
            Some(rest) => asked = rest.strip_prefix('=').map(str::to_owned).or(asked),
            None => {}
        }
    }
    let set = |name: &&str| std::env::var_os(name).filter(|value| !value.is_empty());
    let environment = || ["LC_ALL", "LC_MESSAGES", "LANG"].iter().find_map(set);
    match (asked, settings) {
        (Some(asked), _) => Language::of(&asked),
        (None, Some(language)) => language,
        (None, None) => environment().map_or(Language::English, |name| Language::of(&name.to_string_lossy())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_language_is_found_before_the_arguments_are_read() {
        let asked = |words: &[&str]| {
            requested_language(&words.iter().map(OsString::from).collect::<Vec<_>>(), Some(Language::English))
        };
        assert_eq!(asked(&["dalembert", "list", "--lang", "pt-BR"]), Language::Portuguese);
        assert_eq!(asked(&["dalembert", "--lang=pt-BR", "list"]), Language::Portuguese);
        assert_eq!(asked(&["dalembert", "--lang=en"]), Language::English);
        assert_eq!(requested_language(&[], Some(Language::Portuguese)), Language::Portuguese);
    }
}
