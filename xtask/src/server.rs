//! The program as a server: one process answers many requests.

use std::{
    io::{BufRead, BufReader, Write},
    process::{Child, ChildStdin, ChildStdout, Command, Stdio},
    sync::Mutex,
    thread,
};

use anyhow::{Context, Result, bail};
use serde_json::{Value as Json, json};

use crate::cargo::Program;

/// Number of programs that answer at the same time.
const PROCESSES: usize = 2;

/// A program that answers requests until it is dropped.
pub(crate) struct Server {
    program: Child,
    requests: Option<ChildStdin>,
    replies: BufReader<ChildStdout>,
}

impl Server {
    /// Starts a program that speaks a language.
    pub(crate) fn start(program: &Program, language: &str) -> Result<Self> {
        Self::of(program.in_language(language, &[]))
    }

    /// Starts the program of a command.
    pub(crate) fn of(mut command: Command) -> Result<Self> {
        let started = command.args(["serve", "--stdio"]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
        let mut program = started.context("the program cannot be run")?;
        let requests = program.stdin.take();
        let replies = BufReader::new(program.stdout.take().context("the program prints nothing")?);
        Ok(Self { program, requests, replies })
    }

    /// The reply to a request of this kind.
    ///
    /// # Errors
    /// What the program says is wrong with it.
    pub(crate) fn ask(&mut self, kind: &str, of: &Json) -> Result<Json> {
        let requests = self.requests.as_mut().context("the program reads nothing")?;
        writeln!(requests, "{}", json!({ kind: of })).context("the program has ended")?;
        let mut line = String::new();
        self.replies.read_line(&mut line)?;
        let mut reply: Json = serde_json::from_str(&line).context("the program printed no JSON")?;
        match reply.get("errors") {
            Some(errors) => bail!("{kind} {of}: {errors}"),
            None => Ok(reply["result"].take()),
        }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // Without requests the program ends by itself.
        drop(self.requests.take());
        let _ = self.program.wait();
    }
}

/// Makes something of each item with a server, in the order of the items.
///
/// # Errors
/// The first error of `make`.
pub(crate) fn of_each<T: Sync, R: Send>(
    program: &Program,
    language: &str,
    items: &[T],
    make: impl Fn(&mut Server, &T) -> Result<R> + Sync,
) -> Result<Vec<R>> {
    let waiting = Mutex::new(items.iter().enumerate());
    let next = || waiting.lock().expect("no thread panics while it holds the lock").next();
    let work = || -> Result<Vec<(usize, R)>> {
        let mut server = Server::start(program, language)?;
        let mut made = Vec::new();
        while let Some((n, item)) = next() {
            made.push((n, make(&mut server, item)?));
        }
        Ok(made)
    };
    let made = thread::scope(|scope| {
        let workers: Vec<_> = (0..PROCESSES).map(|_| scope.spawn(work)).collect();
        let made = workers.into_iter().map(|worker| worker.join().expect("a worker does not panic"));
        made.collect::<Result<Vec<_>>>()
    })?;
    let mut made: Vec<(usize, R)> = made.into_iter().flatten().collect();
    made.sort_by_key(|(n, _)| *n);
    Ok(made.into_iter().map(|(_, made)| made).collect())
}
