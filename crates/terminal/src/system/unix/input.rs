//! Waiting for bytes of the terminal, and for a word from another thread.

use std::{
    io::{self, Read, Write},
    os::unix::net::UnixStream,
    sync::Arc,
    time::Duration,
};

use rustix::event::{PollFd, PollFlags, Timespec, poll};

use crate::system::Ready;

/// Ends a wait of [`Session::next_events`](crate::Session::next_events) from another thread: a solver calls it after
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

/// Standard input, and the end of the pipe that wakes.
#[derive(Debug)]
pub(crate) struct Input(UnixStream);

impl Input {
    pub(crate) fn new() -> io::Result<(Self, Waker)> {
        let (near, far) = UnixStream::pair()?;
        near.set_nonblocking(true)?;
        far.set_nonblocking(true)?;
        Ok((Self(near), Waker(Arc::new(far))))
    }

    /// Waits for bytes, a wake or the end of the terminal, for at most `timeout`.
    pub(crate) fn wait(&mut self, timeout: Duration) -> io::Result<Ready> {
        let stdin = rustix::stdio::stdin();
        let mut fds = [PollFd::new(&stdin, PollFlags::IN), PollFd::new(&self.0, PollFlags::IN)];
        let timeout = Timespec { tv_sec: timeout.as_secs() as i64, tv_nsec: timeout.subsec_nanos().into() };
        match poll(&mut fds, Some(&timeout)) {
            Ok(_) => {}
            // A signal; its thread has woken us, or will.
            Err(rustix::io::Errno::INTR) => return Ok(Ready::default()),
            Err(error) => return Err(error.into()),
        }
        let (input, wake) = (fds[0].revents(), fds[1].revents());
        let woken = wake.contains(PollFlags::IN);
        if woken {
            while self.0.read(&mut [0; 64]).is_ok_and(|count| count > 0) {}
        }
        let gone = input.intersects(PollFlags::HUP | PollFlags::ERR | PollFlags::NVAL);
        Ok(Ready { readable: input.contains(PollFlags::IN), woken, gone })
    }

    /// Takes the bytes that are there; `None` where the terminal is gone.
    pub(crate) fn read(&mut self, buffer: &mut [u8]) -> io::Result<Option<usize>> {
        match rustix::io::read(rustix::stdio::stdin(), buffer) {
            Ok(0) | Err(rustix::io::Errno::IO) => Ok(None),
            Ok(count) => Ok(Some(count)),
            Err(rustix::io::Errno::INTR | rustix::io::Errno::AGAIN) => Ok(Some(0)),
            Err(error) => Err(error.into()),
        }
    }
}
