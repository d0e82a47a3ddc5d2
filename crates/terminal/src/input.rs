//! Standard input as keys, mouse reports and pastes.

use std::{
    io,
    time::{Duration, Instant},
};

#[cfg(feature = "pixels")]
use super::pixels::Answers;
use super::{
    decode::{Decoder, TerminalInput},
    system::{Input, Ready, Waker},
};

/// Standard input, decoded.
#[derive(Debug)]
pub(super) struct Reader {
    decoder: Decoder,
    /// Time at which the sequence under way stops waiting for its end.
    deadline: Option<Instant>,
    input: Input,
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
        let (input, waker) = Input::new()?;
        let reader = Self {
            decoder: Decoder::default(),
            deadline: None,
            input,
            buffer: vec![0; 64 * 1024].into_boxed_slice(),
            #[cfg(feature = "pixels")]
            asked: None,
        };
        Ok((reader, waker))
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
            let Ready { readable, woken, gone } = self.input.wait(wait)?;
            if readable {
                let Some(count) = self.input.read(&mut self.buffer)? else { return Ok(WaitResult::HungUp) };
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
}
