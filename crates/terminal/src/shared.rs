//! State that the threads of a session, its signals and its panic hook have in common.

use std::{
    io::{self, Write},
    sync::{
        Mutex, MutexGuard, PoisonError, TryLockError,
        atomic::{AtomicBool, Ordering::SeqCst},
        mpsc,
    },
    thread,
    time::{Duration, Instant},
};

use crossterm::terminal::disable_raw_mode;

use super::{
    catch_panic,
    pixels::FORGET,
    system::{Waker, enable_raw_mode},
};

/// Alternate screen, bracketed paste, no cursor.
const ENTER: &str = "\x1b[?1049h\x1b[?2004h\x1b[?25l";
/// Buttons, drags, the wheel and every movement, in SGR coordinates.
const ENTER_MOUSE: &str = "\x1b[?1000h\x1b[?1002h\x1b[?1003h\x1b[?1006h";
/// The mouse is the terminal's own again.
const LEAVE_MOUSE: &str = "\x1b[?1006l\x1b[?1003l\x1b[?1002l\x1b[?1000l";
/// Everything that [`ENTER`] or an interrupted frame could have set. On a terminal that is already right it changes
/// nothing but the cursor's place.
pub(super) const LEAVE: &str =
    "\x1b[?2026l\x1b[?1006l\x1b[?1003l\x1b[?1002l\x1b[?1000l\x1b[?2004l\x1b[0m\x1b[?1049l\x1b[?25h";

/// Time that a process that has to end waits for its autosave, and for a terminal that does not take its bytes.
const LAST_WISH: Duration = Duration::from_secs(2);

/// Work that must be kept when the program ends without asking; see [`Options`](super::Options).
pub(super) type Autosave = Box<dyn Fn() + Send + Sync>;

pub(super) struct Shared {
    mouse: AtomicBool,
    autosave: Option<Autosave>,
    /// The terminal is ours at this moment: not before `take`, not while suspended, not after `give_back`.
    active: AtomicBool,
    /// Another program has the terminal, because we started it there.
    pub(super) released: AtomicBool,
    /// Held while a frame is written, so that nothing cuts it in two.
    frame: Mutex<()>,
    /// The next frame must paint every cell.
    pub(super) repaint: AtomicBool,
    /// Pictures may be at the terminal, which it is to forget when it is given back.
    pub(super) pictures: AtomicBool,
    /// The window changed its size.
    pub(super) resized: AtomicBool,
    /// Messages of other threads for the user.
    notices: Mutex<Vec<String>>,
    ending: AtomicBool,
    pub(super) waker: Waker,
}

impl Shared {
    pub(super) fn new(mouse: bool, autosave: Option<Autosave>, waker: Waker) -> Self {
        Self {
            mouse: AtomicBool::new(mouse),
            autosave,
            active: AtomicBool::new(false),
            released: AtomicBool::new(false),
            frame: Mutex::new(()),
            repaint: AtomicBool::new(true),
            pictures: AtomicBool::new(false),
            resized: AtomicBool::new(false),
            notices: Mutex::new(Vec::new()),
            ending: AtomicBool::new(false),
            waker,
        }
    }

    pub(super) fn is_active(&self) -> bool {
        self.active.load(SeqCst)
    }

    /// Raw mode, alternate screen and the rest. Raw mode comes first: for a process in the background it is the call
    /// that stops it, before anything is written over the shell's screen.
    pub(super) fn take(&self) -> io::Result<()> {
        let _frame = self.frame();
        if self.is_active() {
            return Ok(());
        }
        enable_raw_mode()?;
        self.active.store(true, SeqCst);
        self.repaint.store(true, SeqCst);
        write(if self.mouse.load(SeqCst) { &[ENTER, ENTER_MOUSE] } else { &[ENTER] })
    }

    /// Asks the terminal something.
    #[cfg(feature = "pixels")]
    pub(super) fn ask(&self, question: &str) -> io::Result<()> {
        let _frame = self.frame();
        if self.is_active() { write(&[question]) } else { Ok(()) }
    }

    /// Takes the mouse, or leaves it to the terminal, now and whenever the terminal is taken again.
    pub(super) fn set_mouse(&self, taken: bool) -> io::Result<()> {
        let _frame = self.frame();
        self.mouse.store(taken, SeqCst);
        if self.is_active() { write(&[if taken { ENTER_MOUSE } else { LEAVE_MOUSE }]) } else { Ok(()) }
    }

    /// Gives the terminal back as it was. Only the first call does anything: a second one would hide what was written
    /// in between. The caller holds the frame lock, or knows that no frame can be under way.
    pub(super) fn give_back(&self) {
        if !self.active.swap(false, SeqCst) {
            return;
        }
        // A terminal that is gone needs nothing; there is nobody to tell.
        let pictures = if self.pictures.load(SeqCst) { FORGET } else { "" };
        let _ = write(&[pictures, LEAVE]);
        let _ = disable_raw_mode();
    }

    pub(super) fn frame(&self) -> MutexGuard<'_, ()> {
        self.frame.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The frame lock, or nothing when a frame has been stuck in a terminal for too long.
    fn frame_within(&self, limit: Duration) -> Option<MutexGuard<'_, ()>> {
        let start = Instant::now();
        loop {
            match self.frame.try_lock() {
                Ok(guard) => return Some(guard),
                Err(TryLockError::Poisoned(poisoned)) => return Some(poisoned.into_inner()),
                Err(TryLockError::WouldBlock) if start.elapsed() > limit => return None,
                Err(TryLockError::WouldBlock) => thread::sleep(Duration::from_millis(5)),
            }
        }
    }

    pub(super) fn notify(&self, notice: String) {
        self.notices.lock().unwrap_or_else(PoisonError::into_inner).push(notice);
        self.waker.wake();
    }

    pub(super) fn notices(&self) -> Vec<String> {
        std::mem::take(&mut *self.notices.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Runs the autosave on a thread of its own and waits a limited time: the thread that died may hold what the
    /// autosave waits for, and a panic in it must not keep the terminal.
    pub(super) fn save(self: &std::sync::Arc<Self>) {
        if self.autosave.is_none() {
            return;
        }
        let (done, wait) = mpsc::channel();
        let shared = self.clone();
        thread::spawn(move || {
            let _ = catch_panic(|| shared.autosave.as_ref().map(|save| save()));
            let _ = done.send(());
        });
        let _ = wait.recv_timeout(LAST_WISH);
    }

    /// Saves, gives the terminal back and ends the process with 128 + `signal`. Needs nothing of the thread that
    /// draws. Calls after the first wait for the first.
    pub(super) fn end(self: &std::sync::Arc<Self>, signal: i32) -> ! {
        if self.ending.swap(true, SeqCst) {
            loop {
                thread::park();
            }
        }
        self.save();
        // A terminal that takes no bytes (a stopped line, a wedged multiplexer) must not keep the process.
        thread::spawn(move || {
            thread::sleep(LAST_WISH);
            let _ = disable_raw_mode();
            std::process::exit(128 + signal);
        });
        let _frame = self.frame_within(Duration::from_millis(500));
        self.give_back();
        std::process::exit(128 + signal)
    }
}

/// Writes to the terminal in one go.
fn write(parts: &[&str]) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(parts.concat().as_bytes())?;
    stdout.flush()
}
