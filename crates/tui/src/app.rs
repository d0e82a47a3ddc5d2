//! The run loop: the one place where effects happen.

mod editor;
mod pace;
mod playing;
mod watch;
mod wheel;

use std::{
    fs, io,
    path::PathBuf,
    process::ExitCode,
    sync::{Arc, mpsc},
    time::{Duration, Instant},
};

use crossterm::{Command, clipboard::CopyToClipboard};
use dalembert_core::{Entry, Language, Text, catalogue};

use self::{
    pace::Pace,
    watch::WatchedFile,
    wheel::{is_moved, limit_wheel},
};
use crate::{
    bench::Bench,
    dialog::Editing,
    effect::Effect,
    files::{self, Autosave, Memory},
    glyphs::{Capabilities, Colors, Environment, Glyphs, PlotMarker},
    look::Appearance,
    model::{EditError, Model, Msg},
    replay::{Player, Recorder, Replay, draw_caption},
    settings::{self, Settings},
    solver::{Solver, case_checker},
    terminal::{self, Fault, Guarded, Session, TerminalError, TerminalInput, fault},
    update::{start, update},
    view::{tempo, view},
};

/// A frame waits so long for the results of the key that it shows.
const PATIENCE: Duration = Duration::from_millis(12);
/// Unsaved work is written aside when nothing was typed for so long.
const KEEP_AFTER: Duration = Duration::from_secs(1);
/// While a user goes on typing, so often.
const KEEP_WHILE_TYPING: Duration = Duration::from_secs(10);
/// Interval at which the progress of a job under way is examined.
const PROGRESS_EVERY: Duration = Duration::from_millis(250);
/// Nothing is expected: until then the loop sleeps.
const LONG: Duration = Duration::from_hours(24);
/// The exit code when the terminal cannot be had.
const NO_TERMINAL: u8 = 2;

/// Options of a session.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// A problem file to open.
    pub file: Option<PathBuf>,
    /// An analysis to open, with its first case.
    pub analysis: Option<&'static Entry>,
    /// The language to begin with.
    pub language: Language,
    /// Settings of the user, with those of the command line applied.
    pub settings: Settings,
    /// Ignored settings, and the path of their file.
    pub faults: Option<(PathBuf, Vec<settings::Fault>)>,
    /// Nothing is saved.
    pub readonly: bool,
    /// For serial lines and screen readers: no frames, no colours, and the cursor where the focus is.
    pub basic: bool,
    /// Path of the file that records the user's actions for a replay.
    pub record: Option<PathBuf>,
    /// Field mode begins with the file, or with a blank job that is to be saved in the file of this name.
    pub field: Option<Option<PathBuf>>,
    /// A session that is played first, so many times as fast as a user types.
    pub replay: Option<(Replay, f64)>,
    /// The session is the tour: it ends in one of the user's own, and any key is hers.
    pub tour: bool,
}

/// Runs the workbench until the user ends it. The exit code is 0, or 2 when the terminal cannot be had.
pub fn run(options: Options) -> ExitCode {
    let words =
        Guarded { name: "dalembert", advice: Some("work kept by the autosave is offered at the next start") };
    terminal::run_guarded(&words, || match workbench(options) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}{}", advice(&error));
            ExitCode::from(NO_TERMINAL)
        }
    })
}

/// Advice after an error of the terminal: what to use instead.
fn advice(error: &TerminalError) -> &'static str {
    match error {
        TerminalError::InputNotATerminal | TerminalError::OutputNotATerminal | TerminalError::NoSequences => {
            ": write `dalembert solve FILE` for plain output"
        }
        TerminalError::Dumb(_) => {
            ": write `dalembert solve FILE`, or set TERM to what your terminal is, such as `TERM=xterm-256color`"
        }
        TerminalError::Failed { .. } => "",
    }
}

/// Runtime on which effects act.
struct Runtime {
    session: Session,
    solver: Solver,
    /// Solver for questions beside the results, so that these are never delayed.
    asker: Solver,
    autosave: Arc<Autosave>,
    case_checker: io::Result<mpsc::Sender<&'static Entry>>,
    /// `None`: nothing is remembered for later sessions.
    memory: Option<Memory>,
    /// Time at which work was remembered that is not autosaved yet.
    noted: Option<Instant>,
    /// Time of the last autosave.
    kept: Instant,
    /// The newest job and when it was given, while its outcome has not come.
    pending: Option<(u64, Instant)>,
    /// The user's editor, where the settings name one.
    editor: Option<String>,
    /// The open file, and what it was when it was examined last.
    watched: Option<WatchedFile>,
    recorder: Option<Recorder>,
    /// The session that is played, until it ends or a key takes over.
    player: Option<Player>,
}

fn workbench(options: Options) -> Result<(), TerminalError> {
    terminal::usable()?;
    let Options { file, analysis, language, settings, faults, readonly, basic, record, field, replay, tour } =
        options;
    let mut capabilities = Capabilities::detect(&Environment::of_process());
    if settings.ascii || basic {
        capabilities.glyphs = Glyphs::Ascii;
        capabilities.marker = PlotMarker::Ascii;
    }
    if basic {
        capabilities.colors = Colors::None;
    }
    let mouse = settings.mouse.unwrap_or(!is_remote());
    let (autosave, trouble) = if readonly { (Autosave::default(), None) } else { Autosave::open() };
    let autosave = Arc::new(autosave);
    let last_words = autosave.clone();
    let session = Session::enter(terminal::Options {
        mouse,
        plain: basic,
        pictures: settings.wait_for_pixels(&capabilities, is_remote()),
        capabilities,
        autosave: Some(Box::new(move || {
            // Nobody is left to be reported.
            let _ = last_words.flush();
        })),
    })?;
    let (sender, messages) = mpsc::channel();
    let solver = Solver::new(teller(&sender, &session, Msg::Solved));
    let asker = Solver::new(teller(&sender, &session, Msg::Asked));
    let look = Appearance::new(&capabilities);
    let mut model = Model::new(catalogue(), language, look, capabilities.marker);
    model.adopt(&settings);
    model.mouse = mouse;
    model.look.basic = basic;
    model.playing &= !basic;
    model.readonly = readonly;
    model.is_replay = replay.is_some();
    model.field = field;
    model.faults = Fault::allowed();
    let case_checker = case_checker(teller(&sender, &session, |(id, cases)| Msg::CheckedCase(id, cases)));
    let mut faulty: Vec<_> = faults.into_iter().filter(|(_, faults)| !faults.is_empty()).collect();
    if let Some(folder) = files::sets_path() {
        let (sets, wrong) = files::sets(&folder);
        model.sets.extend(sets);
        faulty.extend(wrong);
    }
    let (memory, forgetful) = recall(&mut model, teller(&sender, &session, Msg::Trouble));
    // What the tour does is nobody's work.
    model.readonly |= tour;
    let mut world = Runtime {
        session,
        solver,
        asker,
        autosave,
        case_checker,
        memory,
        noted: None,
        kept: Instant::now(),
        pending: None,
        editor: settings.editor,
        watched: None,
        recorder: None,
        player: replay.map(|(replay, speed)| Player::new(replay, speed, tour)),
    };
    if let Some(path) = &record {
        let path_of_file = file.as_ref().and_then(|path| std::path::absolute(path).ok());
        let open = analysis.map(|entry| entry.about.id.to_owned());
        let open = open.or(path_of_file.map(|path| path.display().to_string()));
        let open = open.map(|open| format!("open {open}"));
        let field = model.field.as_ref().map(|job| match job {
            Some(job) => format!("field {}", job.display()),
            None => "field".to_owned(),
        });
        let first: Vec<String> = open.into_iter().chain(field).collect();
        match Recorder::begin(path, world.session.size(), language, &look, &first) {
            Ok(recorder) => world.recorder = Some(recorder),
            Err(error) => not_recorded(&mut model, &error),
        }
    }
    let effects = start(&mut model, file, analysis);
    if world.perform(&mut model, effects) {
        return Ok(());
    }
    if let Some(error) = trouble {
        update(&mut model, Msg::Trouble(error));
    }
    let sessions = world.autosave.crashed();
    for error in forgetful {
        update(&mut model, Msg::Trouble(error));
    }
    if !sessions.is_empty() && !tour {
        update(&mut model, Msg::Crashed(sessions));
    }
    // A session that is played does not know of a message over its screen.
    if !model.is_replay {
        update(&mut model, Msg::Faulty(faulty));
    }
    world.run(&mut model, &messages)
}

impl Runtime {
    fn run(&mut self, model: &mut Model, messages: &mpsc::Receiver<Msg>) -> Result<(), TerminalError> {
        // A frame is drawn only after something happened, or for an animation: an idle screen costs nothing.
        let mut stale = true;
        let pace = Pace::of_line(is_remote());
        let (mut drawn, mut took) = (Instant::now(), Duration::ZERO);
        loop {
            // A key and what it leads to belong in one frame, if it can be had without waiting long.
            loop {
                let wait = self.pending.map_or(Duration::ZERO, |(_, given)| {
                    (given + PATIENCE).saturating_duration_since(Instant::now())
                });
                let Ok(msg) = messages.recv_timeout(wait) else { break };
                stale = true;
                self.pending = self
                    .pending
                    .filter(|(job, _)| !matches!(&msg, Msg::Solved(outcome) if outcome.generation == *job));
                let effects = update(model, msg);
                if self.perform(model, effects) {
                    return Ok(());
                }
            }
            if stale {
                drawn = Instant::now();
                self.session.draw_pictures(|frame| {
                    model.size = (frame.area().width, frame.area().height);
                    let pictures = view(model, frame);
                    draw_caption(model, frame);
                    pictures
                })?;
                stale = false;
                took = drawn.elapsed();
            }
            let in_pixels = model.look.pixels.is_some();
            let tempo = tempo(model);
            let sent = (self.session.frame_bytes(), took);
            let animation = tempo.map(|tempo| drawn + pace.time_to_next(tempo, sent, in_pixels));
            let keep = self.noted.map(|noted| noted + KEEP_AFTER);
            let look = WatchedFile::follow(&mut self.watched, model).map(|watched| watched.next);
            // A session without anything left to do has ended now.
            let played = self.player.as_ref().map(|player| player.due().unwrap_or_else(Instant::now));
            let is_working = model.bench.as_ref().is_some_and(Bench::is_working);
            let progress = is_working.then(|| Instant::now() + PROGRESS_EVERY);
            let next = animation.into_iter().chain(keep).chain(look).chain(played).chain(progress).min();
            let wait = next.map_or(LONG, |next| next.saturating_duration_since(Instant::now()));
            let mut inputs = self.session.next_events(wait)?;
            if self.player.is_some() {
                let (msg, said) = self.play(model, &mut inputs);
                stale |= said || msg.is_some();
                let effects = msg.map_or_else(Vec::new, |msg| update(model, msg));
                if self.perform(model, effects) {
                    return Ok(());
                }
            }
            // Keys come first: an animation waits for them.
            if inputs.is_empty() && animation.is_some_and(|animation| animation <= Instant::now()) {
                stale = true;
                for _ in 0..tempo.map_or(1, |tempo| pace::steps(tempo, drawn.elapsed(), in_pixels)) {
                    update(model, Msg::Tick);
                }
            }
            let percentage = if is_working { self.solver.percentage() } else { None };
            if percentage != model.progress {
                stale = true;
                update(model, Msg::Progress(percentage));
            }
            let resting = |noted: Instant| noted.elapsed() >= KEEP_AFTER && inputs.is_empty();
            if self.noted.is_some_and(|noted| resting(noted) || self.kept.elapsed() > KEEP_WHILE_TYPING) {
                stale |= self.keep(model);
            }
            let known =
                model.bench.as_ref().and_then(|bench| bench.problem.document.file.as_ref()?.fingerprint);
            if let Some(msg) = self.watched.as_mut().and_then(|watched| watched.look(known)) {
                stale = true;
                let effects = update(model, msg);
                if self.perform(model, effects) {
                    return Ok(());
                }
            }
            let mut waiting: Vec<Effect> = Vec::new();
            for input in limit_wheel(inputs) {
                // A movement over nothing that is read there changes no cell.
                let (moves, before) = (is_moved(&input), model.under_pointer);
                let msg = match input {
                    TerminalInput::Key(key) => Msg::Key(key),
                    TerminalInput::Paste(text) => Msg::Paste(text),
                    TerminalInput::Resize { columns, rows } => {
                        // The font may have changed.
                        model.look.pixels = model.look.pixels.and(self.session.cell());
                        Msg::Resize(columns, rows)
                    }
                    TerminalInput::Notice(text) => Msg::Notice(text),
                    TerminalInput::Mouse(event) => Msg::Mouse(event),
                    TerminalInput::Graphics => {
                        model.look.pixels = self.session.graphics().map(|graphics| graphics.cell);
                        stale = true;
                        continue;
                    }
                    TerminalInput::Redraw => {
                        stale = true;
                        continue;
                    }
                };
                let in_dialog = model.dialog.is_some();
                let noted = self.recorder.as_mut().map(|recorder| recorder.note(&msg, in_dialog));
                if let Some(Err(error)) = noted {
                    self.recorder = None;
                    not_recorded(model, &error);
                }
                let effects = update(model, msg);
                stale |= !moves || before.or(model.under_pointer).is_some();
                for effect in effects {
                    waiting.retain(|older| !older.is_idle_after(&effect));
                    waiting.push(effect);
                }
                // Held keys are one change: it is solved once, with the last of them.
                let at_once = waiting.iter().any(|effect| !effect.may_wait());
                if at_once && self.perform(model, std::mem::take(&mut waiting)) {
                    return Ok(());
                }
            }
            if self.perform(model, waiting) {
                return Ok(());
            }
        }
    }

    /// Does what is to be done; whether the program ends.
    fn perform(&mut self, model: &mut Model, effects: Vec<Effect>) -> bool {
        for effect in effects {
            let msg = match effect {
                // The program belongs to who looks on, not to the session.
                Effect::Quit if self.player.is_some() => {
                    self.hand_over(model, false);
                    continue;
                }
                Effect::Suspend if self.player.is_some() => continue,
                Effect::Quit => {
                    // Nobody is left to be reported.
                    let _ = self.recorder.as_mut().map(Recorder::forget_the_end);
                    return true;
                }
                Effect::Solve(job) => {
                    self.pending = Some((job.generation, Instant::now()));
                    // What was asked belongs to older inputs.
                    self.asker.cancel();
                    self.solver.submit(job);
                    continue;
                }
                Effect::Ask(job) => {
                    self.asker.submit(job);
                    continue;
                }
                Effect::Cancel => {
                    self.pending = None;
                    self.solver.cancel();
                    self.asker.cancel();
                    continue;
                }
                Effect::Judge(entry) => {
                    match &self.case_checker {
                        // A thread that has ended accepts no further requests.
                        Ok(case_checker) => {
                            let _ = case_checker.send(entry);
                            continue;
                        }
                        Err(error) => Msg::Notice(error.to_string()),
                    }
                }
                Effect::Save { path, text, before } => {
                    let path = files::at_home(path);
                    let result = files::save(&path, &text, before);
                    Msg::Saved { path, text, result }
                }
                Effect::Export { files, before } => {
                    let files: Vec<_> =
                        files.into_iter().map(|(path, bytes)| (files::at_home(path), bytes)).collect();
                    let (path, result) = files::save_all(&files, before);
                    Msg::Exported { path, result }
                }
                Effect::SavePlan { path, text, before } => {
                    let path = files::at_home(path);
                    let result = files::save(&path, &text, before);
                    Msg::PlanSaved { path, text, result }
                }
                Effect::ReadPlan(path) => {
                    let path = files::at_home(path);
                    let result = files::read(&path);
                    Msg::PlanRead { path, result }
                }
                Effect::Open(path) => {
                    let path = files::at_home(path);
                    let result = files::read(&path);
                    Msg::Opened { path, result }
                }
                Effect::ReadLinked { problem, path, text } => {
                    Msg::LinkedRead(problem, files::LinkedTexts::of(&path, &text))
                }
                Effect::List(folder) => {
                    let names = files::list(&files::at_home(folder.clone()));
                    Msg::Listed(folder, names)
                }
                Effect::ReadTable { field, path, columns } => {
                    let (result, sample) = files::preview_table(&files::at_home(path.clone()), columns);
                    Msg::TableRead { field, path, result, sample }
                }
                Effect::Keep { problem, original, text } => {
                    self.autosave.note(problem, original.as_deref(), text);
                    self.noted = Some(Instant::now());
                    continue;
                }
                Effect::Forget(problem) => {
                    self.autosave.forget(problem);
                    continue;
                }
                Effect::Remember(change) => {
                    if let Some(memory) = &self.memory {
                        memory.note(change);
                    }
                    continue;
                }
                Effect::Discard(crashed) => {
                    // What takes its place must be safe first.
                    self.keep(model);
                    match crashed.discard() {
                        Ok(()) => continue,
                        Err(error) => Msg::Trouble(error),
                    }
                }
                Effect::Copy(text) => {
                    let mut bytes = String::new();
                    let sent = CopyToClipboard::to_clipboard_from(text).write_ansi(&mut bytes).is_ok()
                        && self.session.send(bytes.as_bytes()).is_ok();
                    if sent {
                        continue;
                    }
                    Msg::Notice("the terminal did not take the text".to_owned())
                }
                Effect::Edit(file) => {
                    self.keep(model);
                    self.edit(file)
                }
                Effect::Remove(path) => {
                    // A copy in the folder of temporary files does no harm if it stays.
                    let _ = fs::remove_file(path);
                    continue;
                }
                Effect::Mouse(taken) => match self.session.set_mouse(taken) {
                    Ok(()) => continue,
                    Err(error) => Msg::Notice(error.to_string()),
                },
                Effect::Fault(kind) => {
                    fault(kind, || false);
                    continue;
                }
                Effect::Suspend => {
                    self.keep(model);
                    self.session.suspend();
                    continue;
                }
                Effect::Redraw => {
                    // Every cell changes, and changes back with the next frame; pictures that the terminal keeps are sent anew.
                    match self.session.draw(|frame| {
                        for cell in &mut frame.buffer_mut().content {
                            cell.set_char('.');
                        }
                    }) {
                        Ok(()) => {
                            if model.look.pixels.is_some() {
                                self.session.repaint();
                            }
                            continue;
                        }
                        Err(error) => Msg::Notice(error.to_string()),
                    }
                }
            };
            let effects = update(model, msg);
            if self.perform(model, effects) {
                return true;
            }
        }
        false
    }

    /// Lets the user edit a file, and reads it.
    fn edit(&mut self, file: Editing) -> Msg {
        let path = match &file {
            Editing::Text(text) => match editor::copy(text) {
                Ok(path) => path,
                Err(error) => return Msg::Trouble(error),
            },
            Editing::Copy(path) | Editing::Own(path) => path.clone(),
        };
        let file = if let Editing::Text(_) = file { Editing::Copy(path.clone()) } else { file };
        let command = editor::command(self.editor.as_deref());
        let ended = self.session.release_for(|| editor::run(&command, &path));
        let result = match ended {
            Ok(editor::Ended::Well) => {
                // It was no other program.
                if let Some(watched) = &mut self.watched {
                    watched.seen();
                }
                files::read(&path).map_err(EditError::File)
            }
            Ok(editor::Ended::Badly) => Err(EditError::Editor(command)),
            Ok(editor::Ended::NotFound) => Err(EditError::NoEditor(command)),
            Err(error) => return Msg::Notice(error.to_string()),
        };
        Msg::Edited { file, result }
    }

    /// Writes unsaved work aside; whether there was trouble, which is reported.
    fn keep(&mut self, model: &mut Model) -> bool {
        self.noted = None;
        self.kept = Instant::now();
        match self.autosave.flush() {
            Ok(()) => false,
            Err(error) => {
                update(model, Msg::Trouble(error));
                true
            }
        }
    }
}

/// Returns true for a remote session (SSH): output is reduced, and text is copied through the terminal's own selection.
fn is_remote() -> bool {
    ["SSH_CONNECTION", "SSH_TTY"].iter().any(|name| std::env::var_os(name).is_some())
}

/// Loads the history of earlier sessions; returns the history file, and the error if it could not be read.
fn recall(
    model: &mut Model,
    reported: impl Fn(files::FileError) + Send + 'static,
) -> (Option<Memory>, Vec<files::FileError>) {
    let mut trouble = Vec::new();
    let Some(path) = files::remembered_path() else { return (None, trouble) };
    match files::recall(&path) {
        Ok(remembered) => model.remembered = remembered,
        Err(error) => {
            trouble.push(error);
            return (None, trouble);
        }
    }
    if model.readonly {
        return (None, trouble);
    }
    // Without a thread nothing is remembered, which does no harm now.
    (Memory::of(path, reported).ok(), trouble)
}

/// Tells the loop of something from another thread.
fn teller<T>(
    messages: &mpsc::Sender<Msg>,
    session: &Session,
    msg: impl Fn(T) -> Msg + Send + Sync + 'static,
) -> impl Fn(T) + Send + Sync + 'static {
    let (messages, waker) = (messages.clone(), session.waker());
    move |reported| {
        // A loop that has ended accepts no further messages.
        let _ = messages.send(msg(reported));
        waker.wake();
    }
}

fn not_recorded(model: &mut Model, error: &io::Error) {
    model.report_error(Text::new("recording failed: {error}").with("error", error));
}
