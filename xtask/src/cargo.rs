//! Runs cargo, the program it builds, and programs of the machine.

use std::{
    env,
    ffi::OsString,
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

use anyhow::{Context, Result, bail};

/// The cargo that runs this.
pub(crate) fn cargo(folder: &Path) -> Command {
    let program = env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let mut command = Command::new(program);
    command.current_dir(folder);
    command
}

/// Runs a command whose output is for the user who looks on.
pub(crate) fn run(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("{} cannot be run", shown(command)))?;
    if status.success() { Ok(()) } else { bail!("{} ended with {status}", shown(command)) }
}

/// Runs a command and returns what it prints; its errors go to the user who looks on.
pub(crate) fn output(command: &mut Command) -> Result<String> {
    let output = command
        .stderr(Stdio::inherit())
        .output()
        .with_context(|| format!("{} cannot be run", shown(command)))?;
    if !output.status.success() {
        bail!("{} ended with {}", shown(command), output.status);
    }
    String::from_utf8(output.stdout).with_context(|| format!("{} does not print UTF-8", shown(command)))
}

/// Returns true if a program that prints its version, say, is there and does so.
pub(crate) fn installed(command: &mut Command) -> bool {
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

/// Name of the browser, if one is installed.
pub(crate) fn browser() -> Option<&'static str> {
    const NAMES: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];
    NAMES.into_iter().find(|name| installed(Command::new(name).arg("--version")))
}

/// Runs git in a folder and returns what it prints.
pub(crate) fn git(root: &Path, arguments: &[&str]) -> Result<String> {
    output(Command::new("git").current_dir(root).args(arguments))
}

/// Copies the files that git tracks, unchanged.
pub(crate) fn copy_tracked(root: &Path, to: &Path) -> Result<()> {
    let listed = git(root, &["ls-files", "-z"])?;
    if to.exists() {
        fs::remove_dir_all(to)?;
    }
    for name in listed.split('\0').filter(|name| !name.is_empty()) {
        let (from, to) = (root.join(name), to.join(name));
        if from.is_file() {
            fs::create_dir_all(to.parent().context("a file stands in a folder")?)?;
            fs::copy(&from, &to).with_context(|| format!("{name} cannot be copied"))?;
        }
    }
    Ok(())
}

/// The program, built without optimisation.
pub(crate) struct Program(PathBuf);

impl Program {
    /// Builds the program of the tree in `folder`, among what is built for `root`. All packages are selected, as for the
    /// tests: the program alone would have other features of what it depends on, and all of that would be built twice.
    pub(crate) fn built(folder: &Path, root: &Path) -> Result<Self> {
        let target = target(root);
        run(cargo(folder)
            .args(["build", "--quiet", "--workspace", "--bin", "dalembert"])
            .env("CARGO_TARGET_DIR", &target))?;
        Ok(Self(target.join("debug").join(format!("dalembert{}", env::consts::EXE_SUFFIX))))
    }

    /// Path of its file.
    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    /// To be run with these arguments. Words are English whatever the language of the machine.
    pub(crate) fn with(&self, arguments: &[&str]) -> Command {
        self.in_language("en", arguments)
    }

    /// The same in a language.
    pub(crate) fn in_language(&self, language: &str, arguments: &[&str]) -> Command {
        let mut command = Command::new(&self.0);
        command.args(["--lang", language]).args(arguments);
        command
    }
}

/// Formats a source, whose lines a long name may have filled. Without the formatter it stays as it is.
pub(crate) fn format(source: &Path) {
    let _ = Command::new("rustfmt").args(["--edition", "2024"]).arg(source).status();
}

/// Target directory of the workspace in `root`.
pub(crate) fn target(root: &Path) -> PathBuf {
    // Paths in the variable are relative to where cargo was called.
    env::var_os("CARGO_TARGET_DIR").map_or_else(
        || root.join("target"),
        |target| env::current_dir().map_or_else(|_| PathBuf::from(&target), |here| here.join(&target)),
    )
}

fn shown(command: &Command) -> String {
    let program =
        Path::new(command.get_program()).file_name().unwrap_or_default().to_string_lossy().into_owned();
    let arguments = command.get_args().map(|argument| argument.to_string_lossy());
    let words: Vec<String> = [program].into_iter().chain(arguments.map(Into::into)).collect();
    format!("`{}`", words.join(" "))
}
