//! Benchmark of the response time: from a key that changes an input to the finished frame, and a frame alone.
//!
//! The workbench runs without a terminal: a key is a message, a solve is carried out at once, and the frame is drawn
//! into a buffer. Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them.

use std::time::Instant;

use dalembert_core::{Entry, Language, Stop, registry};
use dalembert_plugins as _;
use dalembert_tui::{
    Effect, Model, Msg,
    glyphs::{Capabilities, Environment},
    look::Appearance,
    solver, start, update, view,
};
use ratatui::{
    Terminal,
    backend::TestBackend,
    crossterm::event::{KeyCode, KeyEvent, KeyModifiers},
};

const ROUNDS: usize = 200;

fn main() {
    for entry in registry() {
        let mut workbench = Workbench::open(entry, 160, 50);
        if !workbench.reach_a_quantity() {
            println!("key to frame, {}\tno quantity to change\t", entry.about.id);
            continue;
        }
        let mut times: Vec<f64> = (0..ROUNDS)
            .map(|n| {
                let start = Instant::now();
                workbench.press(KeyCode::Char(if n % 2 == 0 { '+' } else { '-' }));
                workbench.draw();
                start.elapsed().as_secs_f64() * 1e3
            })
            .collect();
        println!("key to frame 160×50, {}\t{}\t< 16 ms", entry.about.id, figures(&mut times));
    }
    let mut workbench = Workbench::open(registry()[0], 200, 50);
    println!("frame 200×50\t{}\t< 2 ms", figures(&mut workbench.frames()));
    // The frame that takes longest, of all analyses: those with the widest tables and the largest mechanisms.
    let frames = registry().iter().map(|entry| {
        let mut times = Workbench::open(entry, 250, 70).frames();
        (times.select_nth_unstable_by(ROUNDS / 2, f64::total_cmp).1.to_owned(), entry.about.id, times)
    });
    if let Some((_, id, mut times)) = frames.max_by(|(a, ..), (b, ..)| a.total_cmp(b)) {
        println!("slowest frame 250×70, {id}\t{}\t≤ 4 ms", figures(&mut times));
    }
}

fn figures(times: &mut [f64]) -> String {
    times.sort_by(f64::total_cmp);
    format!("{:.2} ms, p99 {:.2} ms", times[times.len() / 2], times[times.len() * 99 / 100])
}

struct Workbench {
    model: Model,
    terminal: Terminal<TestBackend>,
}

impl Workbench {
    /// The first case of an analysis on a screen of this size.
    fn open(entry: &'static Entry, columns: u16, rows: u16) -> Self {
        let capabilities = Capabilities::detect(&Environment::default());
        let look = Appearance::new(&capabilities);
        let model = Model::new(registry(), Language::English, look, capabilities.marker);
        let terminal = Terminal::new(TestBackend::new(columns, rows)).expect("a buffer takes what is drawn");
        let mut workbench = Self { model, terminal };
        let effects = start(&mut workbench.model, None, Some(entry));
        workbench.perform(effects);
        workbench.draw();
        workbench
    }

    /// Times of frames in which nothing has changed, in milliseconds.
    fn frames(&mut self) -> Vec<f64> {
        (0..ROUNDS)
            .map(|_| {
                let start = Instant::now();
                self.draw();
                start.elapsed().as_secs_f64() * 1e3
            })
            .collect()
    }

    /// Moves down the form until a key changes the problem.
    fn reach_a_quantity(&mut self) -> bool {
        (0..60).any(|_| {
            self.press(KeyCode::Down);
            self.press(KeyCode::Char('+'))
        })
    }

    /// Returns true if the key led to a solve.
    fn press(&mut self, code: KeyCode) -> bool {
        let effects = update(&mut self.model, Msg::Key(KeyEvent::new(code, KeyModifiers::NONE)));
        self.perform(effects)
    }

    fn perform(&mut self, effects: Vec<Effect>) -> bool {
        let mut solved = false;
        for effect in effects {
            if let Effect::Solve(job) = effect {
                let outcome = solver::solve(&job, &Stop::new(), &|_| {}).expect("nobody stops it");
                update(&mut self.model, Msg::Solved(outcome));
                solved = true;
            }
        }
        solved
    }

    fn draw(&mut self) {
        let (model, terminal) = (&mut self.model, &mut self.terminal);
        terminal
            .draw(|frame| {
                model.size = (frame.area().width, frame.area().height);
                view(model, frame);
            })
            .expect("a buffer takes what is drawn");
    }
}
