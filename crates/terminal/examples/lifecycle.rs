//! The smallest program on the terminal's lifecycle: it counts keys, has a palette, and can break on demand.
//!
//! The tests of faults drive it as they drive the workbench: `:fault panic` and the like, `:quit`, Ctrl-Z.

use std::{
    process::ExitCode,
    sync::{Arc, Mutex, mpsc},
    thread,
    time::Duration,
};

use dalembert_terminal::{
    Fault, Guarded, Options, Session, TerminalError, TerminalInput, catch_panic, fault,
    glyphs::{Capabilities, Environment},
    run_guarded,
};
use ratatui::{
    Frame,
    crossterm::event::{KeyCode, KeyEvent, KeyModifiers},
    layout::{Constraint, Layout},
    text::Line,
    widgets::{Block, Paragraph},
};

fn main() -> ExitCode {
    run_guarded(&Guarded { name: "dalembert", advice: None }, || match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    })
}

#[derive(Default)]
struct Model {
    keys: u64,
    palette: Option<String>,
    message: String,
}

fn run() -> Result<(), TerminalError> {
    // The autosave writes a copy of the work that the drawing thread renews after every change.
    let work = Arc::new(Mutex::new(String::new()));
    let copy = work.clone();
    let keep = std::env::var_os("LIFECYCLE_AUTOSAVE");
    let autosave = move || {
        if let (Some(path), Ok(work)) = (&keep, copy.lock()) {
            let _ = std::fs::write(path, work.as_bytes());
        }
    };
    let mut session = Session::enter(Options {
        mouse: true,
        plain: false,
        pictures: None,
        capabilities: Capabilities::detect(&Environment::of_process()),
        autosave: Some(Box::new(autosave)),
    })?;
    let (results, solved) = mpsc::channel();
    let mut model = Model::default();
    loop {
        session.draw(|frame| view(&model, frame))?;
        for input in session.next_events(Duration::from_mins(1))? {
            match input {
                TerminalInput::Key(KeyEvent {
                    code: KeyCode::Char('z'),
                    modifiers: KeyModifiers::CONTROL,
                    ..
                }) => {
                    session.suspend();
                }
                TerminalInput::Key(key) => match press(&mut model, key) {
                    Some(Command::Quit) => return Ok(()),
                    Some(Command::Fault(kind)) if kind.belongs_to_solver() => {
                        let (results, waker) = (results.clone(), session.waker());
                        thread::spawn(move || {
                            let result = catch_panic(|| fault(kind, || false));
                            let _ =
                                results.send(result.map_or_else(|panic| panic, |()| format!("{kind} done")));
                            waker.wake();
                        });
                    }
                    Some(Command::Fault(kind)) => fault(kind, || false),
                    None => {}
                },
                TerminalInput::Paste(text) => {
                    if let Some(palette) = &mut model.palette {
                        palette.push_str(&text.replace(char::is_control, " "));
                    }
                }
                TerminalInput::Notice(notice) => model.message = notice,
                TerminalInput::Mouse(_)
                | TerminalInput::Resize { .. }
                | TerminalInput::Graphics
                | TerminalInput::Redraw => {}
            }
        }
        while let Ok(message) = solved.try_recv() {
            model.message = message;
        }
        if let Ok(mut work) = work.lock() {
            *work = format!("keys = {}\n", model.keys);
        }
    }
}

enum Command {
    Quit,
    Fault(Fault),
}

fn press(model: &mut Model, key: KeyEvent) -> Option<Command> {
    model.keys += 1;
    match (key.code, &mut model.palette) {
        (KeyCode::Char(':'), None) => model.palette = Some(String::new()),
        (KeyCode::Esc, _) => model.palette = None,
        (KeyCode::Char(character), Some(palette)) => palette.push(character),
        (KeyCode::Backspace, Some(palette)) => _ = palette.pop(),
        (KeyCode::Enter, Some(_)) => {
            let line = model.palette.take()?;
            if line == "quit" {
                return Some(Command::Quit);
            }
            match line.strip_prefix("fault ").map(str::parse) {
                Some(Ok(kind)) if Fault::allowed() => return Some(Command::Fault(kind)),
                Some(Err(message)) => model.message = message,
                _ => model.message = format!("no command `{line}`"),
            }
        }
        _ => {}
    }
    None
}

fn view(model: &Model, frame: &mut Frame<'_>) {
    let [body, palette] = Layout::vertical([Constraint::Min(0), Constraint::Length(1)]).areas(frame.area());
    let lines = vec![
        Line::from(format!("keys={}", model.keys)),
        Line::from(model.message.as_str()),
        Line::from("ω = √(k/m) ⡠⠊⠉ θ₁ ² ·"),
    ];
    frame.render_widget(Paragraph::new(lines).block(Block::bordered().title("dalembert")), body);
    if let Some(text) = &model.palette {
        let room = usize::from(palette.width).saturating_sub(2);
        let end: String = text.chars().skip(text.chars().count().saturating_sub(room)).collect();
        frame.render_widget(format!(":{end}"), palette);
    }
}
