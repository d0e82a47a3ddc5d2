//! Drives a program through a pseudo-terminal, as a user at a terminal does, and examines what it leaves behind.
//!
//! ```no_run
//! use dalembert_tests::pty::Launch;
//!
//! let mut pty = Launch::new("/usr/bin/dalembert").size(24, 80).env("LANG", "C").start();
//! pty.expect("dalembert");
//! pty.types(":quit<enter>");
//! assert_eq!(pty.exit_code(), Some(0));
//! assert_eq!(pty.leftovers(), [""; 0]);
//! ```
//!
//! The terminal is mute: it answers no question of the program, as a serial line does not, unless it is given answers
//! ([`Launch::answering`]). Programs run with a home
//! folder of their own, which is removed in the end.

mod keys;
mod modes;

use std::{
    collections::BTreeMap,
    ffi::OsString,
    fs::{self, File},
    io::{Read, Write},
    path::{Path, PathBuf},
    sync::{
        Arc, Mutex, MutexGuard, PoisonError,
        atomic::{AtomicBool, Ordering::SeqCst},
    },
    thread::{self, JoinHandle},
    time::{Duration, Instant},
};

use self::modes::Before;
use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, native_pty_system};
pub use rustix::process::Signal;
use rustix::{
    process::{Pid, kill_process, kill_process_group},
    termios::{OptionalActions, tcgetattr, tcsetattr},
};

/// Timeout of [`Pty::expect`] and [`Pty::exit_code`]. Long enough for a machine that is busy with a build.
pub const PATIENCE: Duration = Duration::from_secs(10);

/// Answers of Kitty, with cells of 10 × 20 pixels, to the question for pictures, name, size of a cell, colours and
/// attributes.
pub const KITTY: &[u8] =
    b"\x1b_Gi=31;OK\x1b\\\x1bP>|kitty(0.36.4)\x1b\\\x1b[6;20;10t\x1b]10;rgb:dddd/dddd/dddd\x1b\\\
      \x1b]11;rgb:0000/0000/0000\x1b\\\x1b]4;6;rgb:0d0d/cdcd/cdcd\x1b\\\x1b[?62;c";

/// Bits of a serial line for a byte: eight, a start and a stop.
const BITS: u32 = 10;

/// Options of starting a program.
#[derive(Clone, Debug)]
pub struct Launch {
    program: PathBuf,
    rows: u16,
    columns: u16,
    environment: BTreeMap<OsString, Option<OsString>>,
    arguments: Vec<OsString>,
    front: Front,
    baud: Option<u32>,
    answer: Option<Answer>,
}

/// Answer of the terminal to the question for its device attributes, and after how long it comes.
type Answer = (Duration, Vec<u8>);

/// Process between the terminal and the program.
#[derive(Clone, Debug)]
enum Front {
    Nothing,
    Shell,
    Script(String),
}

impl Launch {
    /// The program in 24 rows of 80 columns, `TERM=xterm-256color`, a UTF-8 locale and no word about colours.
    pub fn new(program: impl Into<PathBuf>) -> Self {
        let launch = Self {
            program: program.into(),
            rows: 24,
            columns: 80,
            environment: BTreeMap::new(),
            arguments: Vec::new(),
            front: Front::Nothing,
            baud: None,
            answer: None,
        };
        let launch = [
            "LC_ALL",
            "LC_CTYPE",
            "COLORTERM",
            "NO_COLOR",
            "DALEMBERT_GUARDED",
            "XDG_STATE_HOME",
            "XDG_CONFIG_HOME",
            "SSH_CONNECTION",
            "SSH_TTY",
            "VISUAL",
            "EDITOR",
            "ENV",
        ]
        .into_iter()
        .fold(launch, Self::without);
        launch.env("TERM", "xterm-256color").env("LANG", "en_US.UTF-8").env("RUST_BACKTRACE", "0")
    }

    /// Another size.
    #[must_use]
    pub fn size(mut self, rows: u16, columns: u16) -> Self {
        (self.rows, self.columns) = (rows, columns);
        self
    }

    /// With an argument; for a program without a shell before it.
    #[must_use]
    pub fn argument(mut self, argument: impl Into<OsString>) -> Self {
        self.arguments.push(argument.into());
        self
    }

    /// With a variable of the environment.
    #[must_use]
    pub fn env(mut self, name: &str, value: &str) -> Self {
        self.environment.insert(name.into(), Some(value.into()));
        self
    }

    /// Without a variable of the environment.
    #[must_use]
    pub fn without(mut self, name: &str) -> Self {
        self.environment.insert(name.into(), None);
        self
    }

    /// Under an interactive shell with job control, as a user starts it; its prompt is `PTY$ `.
    #[must_use]
    pub fn under_shell(mut self) -> Self {
        self.front = Front::Shell;
        self
    }

    /// As a command of a shell script, such as `trap '' HUP; $PROGRAM`.
    #[must_use]
    pub fn in_script(mut self, script: &str) -> Self {
        self.front = Front::Script(script.to_owned());
        self
    }

    /// At the end of a serial line of so many bits a second, ten of which carry a byte.
    #[must_use]
    pub fn baud(mut self, baud: u32) -> Self {
        self.baud = Some(baud);
        self
    }

    /// At a terminal that answers the question for its device attributes (`CSI c`), and those before it, after a time.
    #[must_use]
    pub fn answering(mut self, after: Duration, answer: &[u8]) -> Self {
        self.answer = Some((after, answer.to_vec()));
        self
    }

    /// Starts it.
    pub fn start(self) -> Pty {
        Pty::start(&self)
    }
}

/// The keyboard, while the terminal is there.
type Writer = Arc<Mutex<Option<Box<dyn Write + Send>>>>;

/// A program at its pseudo-terminal. It is killed, with its children, when this is dropped.
pub struct Pty {
    master: Option<Box<dyn MasterPty + Send>>,
    writer: Writer,
    child: Box<dyn Child + Send + Sync>,
    reader: Option<JoinHandle<()>>,
    seen: Arc<Seen>,
    /// The program's side, to read its modes and to wake the reader.
    line: File,
    before: Before,
    /// Time at which the program, or the shell before it, was started.
    pub started: Instant,
    home: tempfile::TempDir,
}

/// Output of the program.
struct Seen {
    output: Mutex<Output>,
    /// The reader takes nothing: a stopped line, a wedged multiplexer.
    paused: AtomicBool,
    /// The bytes that the line carries in a second; 0 is any number.
    rate: u32,
    answer: Option<(Answer, Writer)>,
    closing: AtomicBool,
}

struct Output {
    parser: vt100::Parser,
    raw: Vec<u8>,
    last: Instant,
    /// Number of bytes after each read, and its time.
    arrivals: Vec<(usize, Instant)>,
}

impl Pty {
    fn start(launch: &Launch) -> Self {
        let size = PtySize { rows: launch.rows, cols: launch.columns, pixel_width: 0, pixel_height: 0 };
        let pair = native_pty_system().openpty(size).expect("a pseudo-terminal");
        let home = tempfile::tempdir().expect("a home folder");
        let mut command = CommandBuilder::new(match launch.front {
            Front::Nothing => launch.program.as_os_str(),
            Front::Shell | Front::Script(_) => "bash".as_ref(),
        });
        match &launch.front {
            Front::Nothing => command.args(&launch.arguments),
            Front::Shell => command.args(["--norc", "--noprofile", "-i"]),
            Front::Script(script) => command.args(["--norc", "--noprofile", "-c", script]),
        }
        command.cwd(home.path());
        command.env("HOME", home.path());
        command.env("PROGRAM", &launch.program);
        command.env("PS1", "PTY$ ");
        command.env("HISTFILE", "");
        for (name, value) in &launch.environment {
            match value {
                Some(value) => command.env(name, value),
                None => command.env_remove(name),
            }
        }
        let name = pair.master.tty_name().expect("the line has a name");
        let line = File::options().read(true).write(true).open(name).expect("the line can be opened");
        if let Some(baud) = launch.baud {
            let mut modes = tcgetattr(&line).expect("the line has modes");
            modes.set_speed(baud).expect("a line of this speed");
            tcsetattr(&line, OptionalActions::Now, &modes).expect("the line takes its speed");
        }
        let termios = tcgetattr(&line).expect("the line has modes");
        let writer = pair.master.take_writer().expect("a writer");
        let writer: Writer = Arc::new(Mutex::new(Some(writer)));
        let seen = Arc::new(Seen {
            answer: launch.answer.clone().map(|answer| (answer, writer.clone())),
            output: Mutex::new(Output {
                parser: vt100::Parser::new(launch.rows, launch.columns, 0),
                raw: Vec::new(),
                last: Instant::now(),
                arrivals: Vec::new(),
            }),
            rate: launch.baud.map_or(0, |baud| baud / BITS),
            paused: AtomicBool::new(false),
            closing: AtomicBool::new(false),
        });
        let source = pair.master.try_clone_reader().expect("a reader");
        let reader = thread::spawn({
            let seen = seen.clone();
            move || seen.read_from(source)
        });
        let started = Instant::now();
        let child = pair.slave.spawn_command(command).expect("the program starts");
        let mut pty = Self {
            writer,
            master: Some(pair.master),
            child,
            reader: Some(reader),
            seen,
            line,
            before: Before { termios, modes: Vec::new() },
            started,
            home,
        };
        if matches!(launch.front, Front::Shell) {
            pty.expect("PTY$");
            pty.idle(Duration::from_millis(80));
            // What the shell's own line editor sets is no fault of the program.
            pty.before = Before { termios: pty.termios(), modes: pty.modes() };
            pty.types("$PROGRAM<enter>");
        }
        pty
    }

    /// Types text; names in angle brackets are keys: `<enter> <tab> <s-tab> <esc> <space> <bs> <del> <ins> <up>
    /// <down> <left> <right> <home> <end> <pgup> <pgdn> <f1>`…`<f12>`, with `c-`, `s-`, `a-` for Ctrl, Shift, Alt
    /// (`<c-c>`, `<a-x>`, `<c-right>`), and `<lt>` for `<` itself.
    pub fn types(&mut self, text: &str) {
        self.send(&keys::bytes_of(text));
    }

    /// Sends bytes as they are.
    pub fn send(&mut self, bytes: &[u8]) {
        let mut writer = self.writer.lock().unwrap_or_else(PoisonError::into_inner);
        let writer = writer.as_mut().expect("the terminal is there");
        writer.write_all(bytes).and_then(|()| writer.flush()).expect("the line takes bytes");
    }

    /// Pastes text, bracketed as the program asked for.
    pub fn paste(&mut self, text: &str) {
        self.send(&[b"\x1b[200~", text.as_bytes(), b"\x1b[201~"].concat());
    }

    /// The screen as text, without the blanks at the end of lines.
    pub fn screen(&self) -> String {
        self.seen.output().parser.screen().contents()
    }

    /// Returns true if the text is on the screen, now or within `patience`.
    pub fn sees(&self, text: &str, patience: Duration) -> bool {
        let end = Instant::now() + patience;
        while !self.screen().contains(text) {
            if Instant::now() > end {
                return false;
            }
            thread::sleep(Duration::from_millis(5));
        }
        true
    }

    /// Waits until the text is on the screen; panics with the screen if it never is.
    #[track_caller]
    pub fn expect(&self, text: &str) {
        assert!(self.sees(text, PATIENCE), "`{text}` is not on the screen:\n{}", self.screen());
    }

    /// Waits until nothing comes for this long, at most [`PATIENCE`].
    pub fn idle(&self, silence: Duration) {
        let start = Instant::now();
        while self.seen.output().last.max(start).elapsed() < silence && start.elapsed() < PATIENCE {
            thread::sleep(Duration::from_millis(5));
        }
    }

    /// Every byte that came so far.
    pub fn raw(&self) -> Vec<u8> {
        self.seen.output().raw.clone()
    }

    /// Bytes received after the first `count`.
    pub fn since(&self, count: usize) -> Vec<u8> {
        self.seen.output().raw.get(count..).unwrap_or_default().to_vec()
    }

    /// Time of arrival of the `count`-th byte.
    pub fn arrival(&self, count: usize) -> Option<Instant> {
        let Output { arrivals, .. } = &*self.seen.output();
        arrivals.get(arrivals.partition_point(|(length, _)| *length < count)).map(|(_, time)| *time)
    }

    /// The home folder of the program.
    pub fn home(&self) -> &Path {
        self.home.path()
    }

    /// Number of bytes received.
    pub fn count(&self) -> usize {
        self.seen.output().raw.len()
    }

    /// The window has another size.
    pub fn resize(&mut self, rows: u16, columns: u16) {
        // The model of the screen cannot wrap within a single row.
        self.seen.output().parser.screen_mut().set_size(rows.max(2), columns.max(2));
        let size = PtySize { rows, cols: columns, pixel_width: 0, pixel_height: 0 };
        self.master.as_ref().expect("the terminal is there").resize(size).expect("any size will do");
    }

    /// The terminal takes no more bytes, or takes them again.
    pub fn pause(&self, paused: bool) {
        self.seen.paused.store(paused, SeqCst);
    }

    /// The window is closed: its side of the line is gone.
    pub fn hang_up(&mut self) {
        self.seen.closing.store(true, SeqCst);
        self.pause(false);
        // The reader waits for a byte; the line carries one from here as well as from the program. A line that is
        // full takes it when it is cut, which is an error to nobody.
        if let Ok(mut line) = self.line.try_clone() {
            thread::spawn(move || line.write_all(b" "));
        }
        if let Some(reader) = self.reader.take() {
            reader.join().expect("the reader does not panic");
        }
        *self.writer.lock().unwrap_or_else(PoisonError::into_inner) = None;
        self.master = None;
    }

    /// The processes of the program, each the child of the one before: with a guard in front, the guard and the
    /// program proper.
    pub fn processes(&self) -> Vec<i32> {
        let leader = self.master.as_ref().and_then(|master| master.process_group_leader());
        let mut chain: Vec<i32> = leader.into_iter().collect();
        while let Some(child) = chain.last().and_then(|&process| children(process).first().copied()) {
            chain.push(child);
        }
        chain
    }

    /// Sends a signal to one of [`processes`](Self::processes), counted from the first, or from the last if negative.
    pub fn signal(&self, which: isize, signal: Signal) {
        let processes = self.processes();
        let at =
            if which < 0 { processes.len().checked_add_signed(which) } else { Some(which.unsigned_abs()) };
        let process = at.and_then(|at| processes.get(at)).expect("the program has this process");
        let _ = kill_process(pid(*process), signal);
    }

    /// Sends a signal to the whole process group in the foreground.
    pub fn signal_group(&self, signal: Signal) {
        let leader = self.master.as_ref().and_then(|master| master.process_group_leader());
        let _ = kill_process_group(pid(leader.expect("there is a foreground group")), signal);
    }

    /// Returns true if the started process still runs.
    pub fn runs(&mut self) -> bool {
        self.child.try_wait().is_ok_and(|status| status.is_none())
    }

    /// Waits for the started process and its exit code; `None` if it does not end within [`PATIENCE`], or ended by a
    /// signal.
    pub fn exit_code(&mut self) -> Option<u32> {
        let end = Instant::now() + PATIENCE;
        while Instant::now() < end {
            if let Ok(Some(status)) = self.child.try_wait() {
                self.drain();
                return status.signal().is_none().then(|| status.exit_code());
            }
            thread::sleep(Duration::from_millis(5));
        }
        None
    }

    /// Waits until everything on the line is read: a zero byte from here comes after all of it, and shows nowhere.
    fn drain(&mut self) {
        let end = Instant::now() + PATIENCE;
        let _ = self.line.write_all(&[0]);
        while self.seen.output().raw.last() != Some(&0) && Instant::now() < end {
            thread::sleep(Duration::from_millis(1));
        }
        self.seen.output().raw.pop_if(|last| *last == 0);
    }
}

impl Drop for Pty {
    fn drop(&mut self) {
        let mut all = self.processes();
        all.extend(self.child.process_id().map(|process| process as i32));
        if self.master.is_some() {
            self.hang_up();
        }
        for process in all {
            // A number from /proc a moment ago; whoever has ended is no concern.
            let _ = kill_process(pid(process), Signal::KILL);
        }
        let _ = self.child.wait();
    }
}

impl Seen {
    fn output(&self) -> MutexGuard<'_, Output> {
        self.output.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn read_from(&self, mut source: Box<dyn Read + Send>) {
        let mut buffer = vec![0; 64 * 1024];
        // A slow line is read in the pieces that it carries in a fiftieth of a second.
        let most = if self.rate == 0 { buffer.len() } else { (self.rate as usize / 50).max(1) };
        while let Ok(count @ 1..) = source.read(&mut buffer[..most]) {
            if self.closing.load(SeqCst) {
                return;
            }
            if self.rate > 0 {
                thread::sleep(Duration::from_secs_f64(count as f64 / f64::from(self.rate)));
            }
            let now = Instant::now();
            let mut output = self.output();
            let asked = b"\x1b[c";
            let from = output.raw.len().saturating_sub(asked.len() - 1);
            output.raw.extend_from_slice(&buffer[..count]);
            if let Some(((after, answer), writer)) = &self.answer
                && output.raw[from..].windows(asked.len()).any(|bytes| bytes == asked)
            {
                let (after, answer, writer) = (*after, answer.clone(), writer.clone());
                thread::spawn(move || {
                    thread::sleep(after);
                    let mut writer = writer.lock().unwrap_or_else(PoisonError::into_inner);
                    writer.as_mut().map(|writer| writer.write_all(&answer))
                });
            }
            output.last = now;
            let length = output.raw.len();
            output.arrivals.push((length, now));
            output.parser.process(&buffer[..count]);
            drop(output);
            while self.paused.load(SeqCst) {
                thread::sleep(Duration::from_millis(5));
            }
        }
    }
}

/// State and processor seconds of a process, from `/proc`; `None` when it is gone or a zombie.
pub fn alive(process: i32) -> Option<f64> {
    /// `USER_HZ`, the same on every Linux.
    const TICKS: f64 = 100.0;
    let stat = fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
    // The name, in parentheses, may hold anything.
    let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks: f64 = fields.get(11)?.parse::<f64>().ok()? + fields.get(12)?.parse::<f64>().ok()?;
    (*fields.first()? != "Z").then_some(ticks / TICKS)
}

/// The program under test: `DALEMBERT_BIN`, or `dalembert` beside the tests, which is built first.
pub fn program() -> PathBuf {
    if let Some(path) = std::env::var_os("DALEMBERT_BIN") {
        return path.into();
    }
    let features = if cfg!(feature = "parquet") { "dalembert/parquet" } else { "" };
    // All packages are selected, so that the program rests on the same dependencies as the tests.
    built("dalembert", &["--workspace", "--bin", "dalembert", "--features", features])
}

/// The smallest program on the terminal's lifecycle, which is built first.
pub fn lifecycle() -> PathBuf {
    built("examples/lifecycle", &["--workspace", "--example", "lifecycle"])
}

/// Programs built by this process: tests run at once, and one of them builds.
static BUILT: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Builds a program beside the tests, with their profile, once; what is up to date costs a fraction of a second.
fn built(name: &str, arguments: &[&str]) -> PathBuf {
    // target/<profile>/deps/<test>
    let test = std::env::current_exe().expect("a test has a path");
    let folder = test.parent().and_then(Path::parent).expect("tests are built in target/<profile>/deps");
    let path = folder.join(name);
    let mut built = BUILT.lock().unwrap_or_else(PoisonError::into_inner);
    if !built.contains(&path) {
        let profile = match folder.file_name().and_then(|name| name.to_str()) {
            Some("debug") | None => "dev",
            Some(profile) => profile,
        };
        let status = std::process::Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
            .args(["build", "--quiet", "--profile", profile])
            .args(arguments)
            .env("CARGO_TARGET_DIR", folder.parent().expect("the profile's folder lies in target"))
            .status();
        assert!(status.is_ok_and(|status| status.success()), "`{}` cannot be built", path.display());
        built.push(path.clone());
    }
    path
}

fn children(process: i32) -> Vec<i32> {
    let listed = fs::read_to_string(format!("/proc/{process}/task/{process}/children")).unwrap_or_default();
    listed.split_whitespace().filter_map(|child| child.parse().ok()).collect()
}

fn pid(process: i32) -> Pid {
    Pid::from_raw(process).expect("a process has a positive number")
}
