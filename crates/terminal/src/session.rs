//! The terminal while it is ours.

use std::{
    cell::RefCell,
    io::{self, Write},
    rc::Rc,
    sync::{Arc, atomic::Ordering::SeqCst},
    thread,
    time::Duration,
};

use ratatui::{Frame, Terminal, layout::Rect};

use crate::{
    TerminalError, TerminalInput, Waker,
    backend::MinimalBackend,
    failed,
    glyphs::{Capabilities, sweep},
    input::{Reader, WaitResult},
    panics,
    pixels::{Graphics, Picture},
    shared::{Autosave, Shared},
    system, usable,
};
#[cfg(feature = "pixels")]
use crate::{
    input::Asked,
    pixels::{Protocol, QUERY, display::Display, is_sane},
};

/// A signal that the guard passes on comes no later than this.
const AFTERMATH: Duration = Duration::from_millis(50);

/// Options of taking the terminal.
#[derive(Default)]
pub struct Options {
    /// Report mouse buttons, drags and the wheel. The terminal's own selection needs Shift then.
    pub mouse: bool,
    /// Frames are sent as they are, not marked as synchronized updates: for terminals that print what they do not know.
    pub plain: bool,
    /// The terminal is asked whether it shows pictures. Its answer counts if it comes no later than so long after the
    /// first call of [`Session::next_events`], which reports it as [`TerminalInput::Graphics`]; nothing waits for it.
    pub pictures: Option<Duration>,
    /// Characters and colours that the terminal can show; every finished frame is reduced to them.
    pub capabilities: Capabilities,
    /// Keeps the work when the program ends without asking: a signal, a lost terminal, a panic of the thread that
    /// draws. It runs on a thread of its own and has 2 s. It must not wait for the thread that draws.
    pub autosave: Option<Box<dyn Fn() + Send + Sync>>,
}

/// The terminal, taken: raw mode, alternate screen, bracketed paste. Dropping it gives the terminal back.
///
/// It belongs to the thread that made it; a panic of that thread gives the terminal back before its message is
/// printed, a panic of any other becomes an [`TerminalInput::Notice`].
pub struct Session {
    terminal: Terminal<MinimalBackend<FrameBytes>>,
    bytes: FrameBytes,
    reader: Reader,
    shared: Arc<Shared>,
    capabilities: Capabilities,
    plain: bool,
    #[cfg(feature = "pixels")]
    display: Option<Display>,
}

impl Session {
    /// Takes the terminal. Fails, without having touched it, where [`usable`] does.
    pub fn enter(options: Options) -> Result<Self, TerminalError> {
        usable()?;
        let Options { mouse, plain, pictures, capabilities, autosave } = options;
        #[cfg_attr(not(feature = "pixels"), expect(unused_mut, reason = "it takes questions about pictures"))]
        let (mut reader, waker) = Reader::new().map_err(failed("open a pipe for its input"))?;
        let autosave: Option<Autosave> = autosave;
        let shared = Arc::new(Shared::new(mouse, autosave, waker));
        let bytes = FrameBytes::default();
        let terminal = Terminal::new(MinimalBackend::new(bytes.clone())).map_err(failed("tell its size"))?;
        panics::watch(&shared);
        system::watch(&shared).map_err(failed("let its signals be watched"))?;
        shared.take().map_err(failed("switch to raw mode"))?;
        #[cfg(not(feature = "pixels"))]
        let _ = pictures;
        #[cfg(feature = "pixels")]
        if let Some(patience) = pictures {
            shared.ask(QUERY).map_err(failed("take a question"))?;
            reader.asked = Some(Asked::new(patience));
        }
        Ok(Self {
            terminal,
            bytes,
            reader,
            shared,
            capabilities,
            plain,
            #[cfg(feature = "pixels")]
            display: None,
        })
    }

    /// Draws a frame: nothing of it is written before it is whole, and it is written as one synchronized update.
    /// While the program is suspended nothing is drawn. A terminal that is gone ends the process, as in
    /// [`next_events`](Self::next_events).
    pub fn draw(&mut self, render: impl FnOnce(&mut Frame<'_>)) -> Result<(), TerminalError> {
        self.draw_pictures(|frame| {
            render(frame);
            Vec::new()
        })
    }

    /// Draws a frame with pictures, as [`draw`](Self::draw) does. The raster of each has as many pixels to a cell of its
    /// area as [`Graphics::cell`] says; text over it is drawn over it. Pictures of the last frame that are not among
    /// these are gone. Without [`graphics`](Self::graphics) none is shown.
    pub fn draw_pictures(
        &mut self,
        render: impl FnOnce(&mut Frame<'_>) -> Vec<Picture>,
    ) -> Result<(), TerminalError> {
        self.bytes.0.borrow_mut().clear();
        let repaint = self.shared.repaint.swap(false, SeqCst);
        #[cfg(feature = "pixels")]
        let size_before = self.terminal.get_frame().area();
        if repaint {
            // Not `clear`: it asks the terminal for its cursor and waits 2 s for one that does not answer.
            let size = self.terminal.size().map_err(failed("tell its size"))?;
            self.terminal
                .resize(Rect::new(0, 0, size.width, size.height))
                .map_err(failed("take a new size"))?;
        }
        let capabilities = &self.capabilities;
        let mut pictures = Vec::new();
        let drawn = self
            .terminal
            .draw(|frame| {
                pictures = render(frame);
                sweep(frame.buffer_mut(), capabilities);
            })
            .map_err(failed("draw a frame"))?;
        #[cfg(feature = "pixels")]
        if let Some(display) = &mut self.display {
            // A screen that is painted anew, or cleared for another size, has lost its pictures.
            let lost = repaint || drawn.area != size_before;
            let shown = if lost { display.forget(&mut self.bytes) } else { Ok(()) };
            shown.map_err(failed("draw a frame"))?;
            if !display.is_idle(&pictures) {
                let frame = drawn.buffer.clone();
                let shown = display.show(pictures, &frame, self.terminal.backend_mut(), &mut self.bytes);
                shown.map_err(failed("draw a frame"))?;
            }
        }
        #[cfg(not(feature = "pixels"))]
        let _ = (drawn, pictures);
        let frame = self.shared.frame();
        if self.shared.is_active() {
            if let Err(error) = self.bytes.write_to(&mut io::stdout().lock(), self.plain) {
                drop(frame);
                if system::terminal_is_lost() {
                    self.shared.end(system::HANG_UP);
                }
                return Err(failed("take a frame")(error));
            }
        } else {
            self.shared.repaint.store(true, SeqCst);
        }
        Ok(())
    }

    /// Columns and rows of the screen.
    pub fn size(&self) -> (u16, u16) {
        // A terminal that does not tell its size is drawn on as it was.
        self.terminal.size().map_or((80, 24), |size| (size.width, size.height))
    }

    /// The length of the last frame, in bytes.
    pub fn frame_bytes(&self) -> usize {
        self.bytes.0.borrow().len()
    }

    /// Inputs since the last call: waits up to `timeout` for the first input, then takes everything that is already
    /// there (for at most 30 ms), so that a burst of keys costs one frame. Empty after `timeout`, or when a [`Waker`]
    /// was used.
    ///
    /// A terminal that is gone ends the process here, as `SIGHUP` would, with the autosave.
    pub fn next_events(&mut self, timeout: Duration) -> Result<Vec<TerminalInput>, TerminalError> {
        let mut inputs = Vec::new();
        let lost = self.shared.is_active() && self.shared.repaint.load(SeqCst);
        let timeout = if lost { Duration::ZERO } else { timeout };
        if self.reader.wait(timeout, &mut inputs).map_err(failed("read keys"))? == WaitResult::HungUp {
            self.shared.end(system::HANG_UP);
        }
        if self.shared.resized.swap(false, SeqCst) {
            let size = self.terminal.size().map_err(failed("tell its size"))?;
            inputs.push(TerminalInput::Resize { columns: size.width, rows: size.height });
        }
        if self.shared.repaint.load(SeqCst) {
            inputs.push(TerminalInput::Redraw);
        }
        #[cfg(feature = "pixels")]
        if let Some(graphics) = self.reader.answers().and_then(|answers| answers.graphics(cell_of_window())) {
            self.shared.pictures.store(graphics.protocol == Protocol::Kitty, SeqCst);
            self.display = Some(Display::new(graphics));
            inputs.push(TerminalInput::Graphics);
        }
        inputs.extend(self.shared.notices().into_iter().map(TerminalInput::Notice));
        Ok(inputs)
    }

    /// Gives the terminal to the shell, as Ctrl-Z is expected to; `fg` takes it back and reports [`TerminalInput::Redraw`].
    /// Where there is no shell to return to, nothing happens and an [`TerminalInput::Notice`] reports it.
    pub fn suspend(&self) {
        if !system::suspend(&self.shared) {
            self.shared.notify("there is no shell to return to: the program goes on".to_owned());
        }
    }

    /// Gives the terminal to another program until that ends, and takes it again. Keys that stop or interrupt are that
    /// program's meanwhile.
    pub fn release_for<T>(&self, program: impl FnOnce() -> T) -> Result<T, TerminalError> {
        {
            let _frame = self.shared.frame();
            self.shared.released.store(true, SeqCst);
            self.shared.give_back();
        }
        let done = program();
        // What interrupted it is on its way to us too, by the guard.
        thread::sleep(AFTERMATH);
        self.shared.released.store(false, SeqCst);
        self.shared.take().map_err(failed("switch to raw mode"))?;
        Ok(done)
    }

    /// Takes the mouse, or leaves it to the terminal.
    pub fn set_mouse(&self, taken: bool) -> Result<(), TerminalError> {
        self.shared.set_mouse(taken).map_err(failed("take a message"))
    }

    /// The next frame paints every cell: something else wrote on the screen, and the user asks for it again.
    pub fn repaint(&self) {
        self.shared.repaint.store(true, SeqCst);
    }

    /// A handle for other threads to end a wait of [`next_events`](Self::next_events).
    pub fn waker(&self) -> Waker {
        self.shared.waker.clone()
    }

    /// Means of the terminal to show pictures, since [`TerminalInput::Graphics`]; nothing, without the feature `pixels`.
    pub fn graphics(&self) -> Option<&Graphics> {
        #[cfg(feature = "pixels")]
        return self.display.as_ref().map(Display::graphics);
        #[cfg(not(feature = "pixels"))]
        None
    }

    /// Pixels across a cell and down a cell after the window or its font has changed; `None` where there are no pictures.
    pub fn cell(&mut self) -> Option<(u16, u16)> {
        #[cfg(feature = "pixels")]
        {
            let display = self.display.as_mut()?;
            match cell_of_window() {
                Some(cell) => display.set_cell(cell),
                // Of a size that nobody reports again, only Kitty's pictures are scaled to their cells.
                None if display.graphics().protocol == Protocol::Kitty => {}
                None => return None,
            }
            Some(display.graphics().cell)
        }
        #[cfg(not(feature = "pixels"))]
        None
    }

    /// Characters and colours that the terminal can show.
    pub fn capabilities(&self) -> &Capabilities {
        &self.capabilities
    }

    /// Sends bytes that are no part of a frame, such as an OSC 52 copy to the clipboard. They must not move the
    /// cursor.
    pub fn send(&mut self, bytes: &[u8]) -> Result<(), TerminalError> {
        let _frame = self.shared.frame();
        if !self.shared.is_active() {
            return Ok(());
        }
        let mut stdout = io::stdout().lock();
        stdout.write_all(bytes).and_then(|()| stdout.flush()).map_err(failed("take a message"))
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        let _frame = self.shared.frame();
        self.shared.give_back();
        panics::forget();
    }
}

/// Pixels across a cell and down a cell, where the system knows them.
#[cfg(feature = "pixels")]
fn cell_of_window() -> Option<(u16, u16)> {
    system::cell().filter(|cell| is_sane(*cell))
}

/// Collects the bytes of a frame; [`Session::draw`] writes them when it is whole.
#[derive(Clone, Default)]
pub(super) struct FrameBytes(pub(super) Rc<RefCell<Vec<u8>>>);

impl FrameBytes {
    /// As one synchronized update (mode 2026), so that a terminal never shows half a frame; or as it is.
    fn write_to(&self, out: &mut impl Write, plain: bool) -> io::Result<()> {
        let bytes = self.0.borrow();
        if plain {
            out.write_all(&bytes)?;
            return out.flush();
        }
        let frame = [b"\x1b[?2026h", &bytes[..], b"\x1b[?2026l"].concat();
        out.write_all(&frame)?;
        out.flush()
    }
}

impl Write for FrameBytes {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
