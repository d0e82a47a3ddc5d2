//! `cargo xtask dist`: the program for people without a Rust toolchain, and the proof that it runs where they are.
//!
//! | file in `artifacts` of the target directory | content |
//! |---|---|
//! | `dalembert-VERSION-ARCH-linux.tar.xz` | static program, manual pages, completions, licences |
//! | `dalembert_VERSION_ARCH.deb` | the same as a Debian package |
//! | `dalembert-VERSION-….whl` | the Python module, with the program as its script |
//! | `dalembert-VERSION-x86_64-windows.zip` | with `--windows`: the program for Windows |
//! | `dalembert-VERSION.cdx.json` | bill of materials in CycloneDX 1.5: the crates in the program |
//! | `SHA256SUMS` | checksums of these |
//!
//! The program is linked with musl: it needs no library of the machine. It names the crates it is built of, as
//! `cargo auditable` writes them, so that `cargo audit bin dalembert` finds advisories about them. Paths of this machine
//! are taken out of it and times are those of the commit, so that a build from another folder has the same bytes.

mod materials;
mod prove;
mod wheel;
mod windows;

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};

use anyhow::{Context, Result, bail, ensure};

use crate::cargo::{cargo, git, installed, output, run as run_command, target};

/// The program that was built, and the folder of what is handed out.
struct Release {
    root: PathBuf,
    /// Folder of the files that are handed out.
    folder: PathBuf,
    version: String,
    /// Time of the commit, in seconds since 1970.
    time: String,
    program: PathBuf,
}

/// Options of `cargo xtask dist`.
const OPTIONS: [&str; 5] = ["--without-wheel", "--windows", "--prove", "--reproduce", "--packages"];

/// Flags of the C compiler without which the allocator holds the time at which it was compiled.
const UNDATED: &str = "-Wno-builtin-macro-redefined -D__DATE__=\"\" -D__TIME__=\"\"";

/// Documents that every archive holds.
const DOCUMENTS: [&str; 4] = ["README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE"];

/// Builds the files that are handed out, `--windows` the program for Windows too; `--prove` installs and runs them in an
/// empty root, in an old Debian and under Wine, `--reproduce` builds the program once more from another folder and compares
/// the bytes, `--packages` packs every crate for a registry and builds it from its package.
///
/// # Errors
/// A tool is missing, something does not build, or a proof fails.
pub fn run(root: &Path, words: &[&str]) -> Result<()> {
    if let Some(unknown) = words.iter().find(|word| !OPTIONS.contains(word)) {
        bail!("{unknown} is no option of dist; these are: {}", OPTIONS.join(", "));
    }
    needed(&["musl-gcc", "tar", "xz", "dpkg-deb", "objcopy", "sha256sum"])?;
    ensure!(
        installed(cargo(root).args(["auditable", "--version"])),
        "cargo-auditable is missing: cargo install cargo-auditable --locked"
    );
    // Not `dist`: there the compiler keeps what the profile of that name needs.
    let folder = target(root).join("artifacts");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder)?;
    let program = built(root, &target(root), &triple())?;
    let version = output(Command::new(&program).arg("--version"))?;
    let version =
        version.split_whitespace().nth(1).context("the program does not say its version")?.to_owned();
    let time = git(root, &["log", "-1", "--format=%ct"])?.trim().to_owned();
    let release = Release { root: root.to_owned(), folder, version, time, program };
    release.archive()?;
    release.package()?;
    materials::write(&release)?;
    if !words.contains(&"--without-wheel") {
        wheel::write(&release)?;
    }
    let for_windows = words.contains(&"--windows").then(|| windows::write(&release)).transpose()?;
    release.checksums()?;
    if words.contains(&"--prove") {
        prove::everywhere(&release)?;
        if let Some(program) = &for_windows {
            windows::prove(&release, program)?;
        }
    }
    if words.contains(&"--reproduce") {
        release.reproduce()?;
    }
    if words.contains(&"--packages") {
        packages(root)?;
    }
    Ok(())
}

/// Packs every crate but those of this repository alone, and builds each from its package.
fn packages(root: &Path) -> Result<()> {
    let others = ["--exclude", "xtask", "--exclude", "dalembert-tests"];
    run_command(cargo(root).args(["package", "--workspace", "--locked"]).args(others))
}

/// Refuses to begin without the programs that are called.
fn needed(programs: &[&str]) -> Result<()> {
    for program in programs {
        let found = Command::new("sh").args(["-c", &format!("command -v {program} >/dev/null")]).status()?;
        ensure!(found.success(), "`{program}` is missing: install it with the packages of your system");
    }
    Ok(())
}

/// Target that needs no library of the machine.
fn triple() -> String {
    format!("{}-unknown-linux-musl", env::consts::ARCH)
}

/// Builds the program for a target from the tree in `root`.
fn built(root: &Path, target: &Path, triple: &str) -> Result<PathBuf> {
    // Where there is no rustup, the target comes with the toolchain or the build says that it is missing.
    let _ = Command::new("rustup").current_dir(root).args(["target", "add", triple]).status();
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(PathBuf::from(env::var_os("HOME")?).join(".cargo")));
    let home = home.context("neither CARGO_HOME nor HOME is set")?;
    let flags = [(root, "/dalembert"), (&home, "/cargo")]
        .map(|(from, to)| format!("--remap-path-prefix={}={to}", from.display()));
    run_command(
        cargo(root)
            .env("CARGO_TARGET_DIR", target)
            .env("CARGO_ENCODED_RUSTFLAGS", flags.join("\x1f"))
            .env("CFLAGS", UNDATED)
            .args(["auditable", "build", "--locked", "--profile", "dist"])
            .args(["--package", "dalembert", "--target", triple]),
    )?;
    Ok(target.join(triple).join("dist").join("dalembert"))
}

impl Release {
    /// A folder with the program, its manual pages, completions and licences in the places of a Unix system.
    fn tree(&self, prefix: &Path) -> Result<()> {
        let place = |path: &str| -> Result<PathBuf> {
            let path = prefix.join(path);
            fs::create_dir_all(path.parent().context("a path in the tree")?)?;
            Ok(path)
        };
        fs::copy(&self.program, place("bin/dalembert")?)?;
        let page =
            |arguments: &[&str]| output(Command::new(&self.program).args(["--lang", "en"]).args(arguments));
        let main = page(&["man"])?;
        fs::write(place("share/man/man1/dalembert.1")?, &main)?;
        for name in subcommands(&main) {
            fs::write(place(&format!("share/man/man1/dalembert-{name}.1"))?, page(&["man", &name])?)?;
        }
        for (shell, path) in [
            ("bash", "share/bash-completion/completions/dalembert"),
            ("zsh", "share/zsh/vendor-completions/_dalembert"),
            ("fish", "share/fish/vendor_completions.d/dalembert.fish"),
        ] {
            fs::write(place(path)?, page(&["completions", shell])?)?;
        }
        for name in DOCUMENTS {
            fs::copy(self.root.join(name), place(&format!("share/doc/dalembert/{name}"))?)?;
        }
        let copyright = "Upstream-Name: dalembert\nLicense: MIT or Apache-2.0, at your choice;\n \
                         the texts are LICENSE-MIT and LICENSE-APACHE in this folder.\n";
        fs::write(place("share/doc/dalembert/copyright")?, copyright)?;
        Ok(())
    }

    /// The archive of the program with what belongs to it.
    fn archive(&self) -> Result<()> {
        let name = format!("dalembert-{}-{}-linux", self.version, env::consts::ARCH);
        self.tree(&self.folder.join(&name))?;
        let archive = self.folder.join(format!("{name}.tar.xz"));
        run_command(
            Command::new("tar")
                .current_dir(&self.folder)
                .args(["--sort=name", "--owner=0", "--group=0", "--numeric-owner", "--mode=go-w"])
                .arg(format!("--mtime=@{}", self.time))
                .args(["--xz", "--create", "--file"])
                .args([archive.as_os_str(), name.as_ref()]),
        )?;
        fs::remove_dir_all(self.folder.join(&name))?;
        report(&archive)
    }

    /// The Debian package.
    fn package(&self) -> Result<()> {
        let architecture = match env::consts::ARCH {
            "x86_64" => "amd64",
            "aarch64" => "arm64",
            other => other,
        };
        let place = self.folder.join("deb");
        self.tree(&place.join("usr"))?;
        fs::create_dir_all(place.join("DEBIAN"))?;
        let size = fs::metadata(&self.program)?.len() / 1024;
        let control = format!(
            "Package: dalembert\nVersion: {}\nArchitecture: {architecture}\nSection: science\nPriority: optional\n\
             Maintainer: dalembert\nInstalled-Size: {size}\nDescription: machine dynamics with worked solutions\n \
             Virtual work, balancing, rigid-body dynamics and vibration in the terminal.\n",
            self.version
        );
        fs::write(place.join("DEBIAN/control"), control)?;
        let package = self.folder.join(format!("dalembert_{}_{architecture}.deb", self.version));
        run_command(
            Command::new("dpkg-deb")
                .env("SOURCE_DATE_EPOCH", &self.time)
                .args(["--root-owner-group", "-Zxz", "--build"])
                .args([&place, &package]),
        )?;
        fs::remove_dir_all(place)?;
        report(&package)
    }

    fn checksums(&self) -> Result<()> {
        let mut names: Vec<String> = Vec::new();
        for entry in fs::read_dir(&self.folder)? {
            let entry = entry?;
            if entry.file_type()?.is_file() {
                names.push(entry.file_name().to_string_lossy().into_owned());
            }
        }
        names.sort();
        let sums = output(Command::new("sha256sum").current_dir(&self.folder).args(&names))?;
        print!("{sums}");
        Ok(fs::write(self.folder.join("SHA256SUMS"), sums)?)
    }

    /// A clone in another folder, built anew, has a program of the same bytes.
    fn reproduce(&self) -> Result<()> {
        let state = git(&self.root, &["status", "--porcelain"])?;
        ensure!(state.trim().is_empty(), "the tree has changes that a clone has not: commit them first");
        let clone = self.folder.join("elsewhere");
        git(&self.root, &["clone", "--quiet", ".", &clone.display().to_string()])?;
        let other = built(&clone, &clone.join("target"), &triple())?;
        ensure!(
            fs::read(&other)? == fs::read(&self.program)?,
            "{} and {} differ",
            other.display(),
            self.program.display()
        );
        println!("built in two folders: the same bytes");
        Ok(fs::remove_dir_all(clone)?)
    }
}

/// Names of the subcommands in the manual page of the program.
fn subcommands(page: &str) -> Vec<String> {
    let names = page.lines().filter_map(|line| line.strip_prefix("dalembert\\-")?.split_once('('));
    let names = names.map(|(name, _)| name.replace('\\', ""));
    names.filter(|name| name != "help").collect()
}

/// Says what was written and how large it is.
fn report(file: &Path) -> Result<()> {
    let size = fs::metadata(file)?.len() as f64 / 1e6;
    println!("{}: {size:.1} MB", file.file_name().unwrap_or_default().to_string_lossy());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subcommands_are_read_from_the_manual_page() {
        let page = ".TP\ndalembert\\-list(1)\nList\n.TP\ndalembert\\-solve(1)\nSolve\n.TP\ndalembert\\-help(1)\nHelp\n";
        assert_eq!(subcommands(page), ["list", "solve"]);
    }
}
