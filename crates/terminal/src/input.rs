//! Waiting for bytes of the terminal, and for a word from another thread.

use std::{
    io::{self, Read, Write},
    os::unix::net::UnixStream,
    sync::Arc,
    time::{Duration, Instant},
};

use rustix::event::{PollFd, PollFlags, Timespec, poll};

use super::decode::{Decoder, TerminalInput};
#[cfg(feature = "pixels")]
use super::pixels::Answers;

/// Ends a wait of [`Session::next_events`](super::Session::next_events) from another thread: a solver calls it after
/// it has left its result where the drawing thread looks.
#[derive(Clone, Debug)]
pub struct Waker(Arc<UnixStream>);

impl Waker {
    /// Ends the present wait, or the next one if nobody waits. Never blocks.
    pub fn wake(&self) {
        // A full pipe already wakes.
        let _ = (&*self.0).write(&[0]);
    }
}

/// Standard input, decoded.
#[derive(Debug)]
pub(super) struct Reader {
    decoder: Decoder,
    /// Time at which the sequence under way stops waiting for its end.
    deadline: Option<Instant>,
    wakes: UnixStream,
    buffer: Box<[u8]>,
    /// Question whether the terminal shows pictures, while an answer is waited for.
    #[cfg(feature = "pixels")]
    pub(super) asked: Option<Asked>,
}

/// A question to the terminal, and what has come since.
#[cfg(feature = "pixels")]
#[derive(Debug)]
pub(super) struct Asked {
    patience: Duration,
    /// End of the patience, from the first time that anybody waits.
    deadline: Option<Instant>,
    bytes: Vec<u8>,
    answers: Option<Answers>,
}

#[cfg(feature = "pixels")]
impl Asked {
    /// Asked just now.
    pub(super) fn new(patience: Duration) -> Self {
        Self { patience, deadline: None, bytes: Vec::new(), answers: None }
    }

    /// Takes bytes of the terminal, which are keys or answers.
    fn take(&mut self, bytes: &[u8]) {
        self.bytes.extend_from_slice(bytes);
        self.answers = Some(Answers::of(&self.bytes)).filter(|answers| answers.complete);
    }
}

/// End of a wait.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum WaitResult {
    /// Bytes were decoded, a wake came, or the time is over.
    Alive,
    /// The terminal is gone.
    HungUp,
}

/// A burst of input is taken for this long before the next frame.
const BURST: Duration = Duration::from_millis(30);

impl Reader {
    pub(super) fn new() -> io::Result<(Self, Waker)> {
        let (near, far) = UnixStream::pair()?;
        near.set_nonblocking(true)?;
        far.set_nonblocking(true)?;
        let reader = Self {
            decoder: Decoder::default(),
            deadline: None,
            wakes: near,
            buffer: vec![0; 64 * 1024].into_boxed_slice(),
            #[cfg(feature = "pixels")]
            asked: None,
        };
        Ok((reader, Waker(Arc::new(far))))
    }

    /// Waits until something happens or `timeout` is over, then takes everything that is already there.
    pub(super) fn wait(
        &mut self,
        timeout: Duration,
        inputs: &mut Vec<TerminalInput>,
    ) -> io::Result<WaitResult> {
        let start = Instant::now();
        let mut first = None;
        #[cfg(feature = "pixels")]
        {
            if let Some(asked) = &mut self.asked {
                asked.deadline.get_or_insert(start + asked.patience);
            }
            self.asked.take_if(|asked| asked.deadline.is_some_and(|deadline| deadline < start));
        }
        loop {
            let patience = self.deadline.map(|deadline| deadline.saturating_duration_since(Instant::now()));
            let left = timeout.saturating_sub(start.elapsed());
            // What is already decoded must not wait for more.
            let wait = if inputs.is_empty() {
                patience.map_or(left, |patience| patience.min(left))
            } else {
                Duration::ZERO
            };
            let (readable, woken, gone) = self.poll(wait)?;
            if readable {
                let count = match rustix::io::read(rustix::stdio::stdin(), &mut self.buffer[..]) {
                    Ok(0) | Err(rustix::io::Errno::IO) => return Ok(WaitResult::HungUp),
                    Ok(count) => count,
                    Err(rustix::io::Errno::INTR | rustix::io::Errno::AGAIN) => 0,
                    Err(error) => return Err(error.into()),
                };
                // To the decoder, answers are nothing.
                self.decoder.feed(&self.buffer[..count], inputs);
                self.deadline = self.decoder.patience().map(|patience| Instant::now() + patience);
                #[cfg(feature = "pixels")]
                if let Some(asked) = &mut self.asked
                    && asked.deadline.is_some_and(|deadline| Instant::now() <= deadline)
                {
                    asked.take(&self.buffer[..count]);
                    if asked.answers.is_some() {
                        return Ok(WaitResult::Alive);
                    }
                }
            } else if gone {
                return Ok(WaitResult::HungUp);
            } else if self.deadline.is_some_and(|deadline| deadline <= Instant::now()) {
                self.decoder.settle(inputs);
                self.deadline = None;
            }
            if woken {
                return Ok(WaitResult::Alive);
            }
            if !inputs.is_empty() {
                let burst = first.get_or_insert_with(Instant::now).elapsed();
                if !readable || burst > BURST {
                    return Ok(WaitResult::Alive);
                }
            } else if start.elapsed() >= timeout {
                return Ok(WaitResult::Alive);
            }
        }
    }

    /// Answers to [`QUERY`](super::pixels::QUERY), once, if they came within the time that is given them.
    #[cfg(feature = "pixels")]
    pub(super) fn answers(&mut self) -> Option<Answers> {
        let answers = self.asked.as_ref()?.answers.clone()?;
        self.asked = None;
        Some(answers)
    }

    /// Polls: standard input can be read, another thread woke us, the terminal is gone.
    fn poll(&mut self, timeout: Duration) -> io::Result<(bool, bool, bool)> {
        let stdin = rustix::stdio::stdin();
        let mut fds = [PollFd::new(&stdin, PollFlags::IN), PollFd::new(&self.wakes, PollFlags::IN)];
        let timeout = Timespec { tv_sec: timeout.as_secs() as i64, tv_nsec: timeout.subsec_nanos().into() };
        match poll(&mut fds, Some(&timeout)) {
            Ok(_) => {}
            // A signal; its thread has woken us, or will.
            Err(rustix::io::Errno::INTR) => return Ok((false, false, false)),
            Err(error) => return Err(error.into()),
        }
        let (input, wake) = (fds[0].revents(), fds[1].revents());
        let woken = wake.contains(PollFlags::IN);
        if woken {
            while self.wakes.read(&mut [0; 64]).is_ok_and(|count| count > 0) {}
        }
        let gone = input.intersects(PollFlags::HUP | PollFlags::ERR | PollFlags::NVAL);
        Ok((input.contains(PollFlags::IN), woken, gone))
    }
}
