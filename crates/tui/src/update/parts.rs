//! The parts of a problem file: the one that is shown, a linked problem more, a configuration more.

use dalembert_core::{Entry, Text, find_analysis, linked, search};

use crate::{
    dialog::{Choice, Chosen, Dialog, Purpose},
    intent::Intent,
    keys::{Action, KeyContext},
    layout::Focus,
    model::Model,
    picker::Listing,
    view,
};

/// So many analyses are offered for words.
const MOST_ANALYSES: usize = 12;

/// Shows the part so many tabs further.
pub(super) fn turn(model: &mut Model, by: isize) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    if bench.problem.inputs.form.turn_part(by) {
        return vec![Intent::BringResults];
    }
    let key = model.key(KeyContext::Form, Action::Palette);
    let said = "one problem without configurations; {key}problem NAME ANALYSIS links another, {key}configuration NAME begins one";
    Intent::say(Text::new(said).with("key", key))
}

/// Shows a part by the place of its tab.
pub(super) fn show(model: &mut Model, at: usize) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let form = &mut bench.problem.inputs.form;
    form.keep();
    if let Some(part) = form.parts().get(at) {
        form.show_part(part);
    }
    vec![Intent::EndEdit, Intent::BringResults]
}

/// Shows what the panes have of the part that is shown; results and working are scrolled to it.
pub(super) fn bring_results(model: &mut Model) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let form = &bench.problem.inputs.form;
    let name = form.part().name;
    // A problem whose pictures have an order of their own is opened with the first of them.
    let is_opened = bench.turned_to.is_empty() && form.parts().first().is_some_and(|part| part.name == name);
    bench.turned_to.clone_from(&name);
    if !(is_opened && bench.problem.entry().is_pictured()) {
        for pane in &mut bench.panes {
            pane.turn_to(&bench.problem, &name);
        }
    }
    for tab in bench.all_tabs() {
        let Some(bench) = &mut model.bench else { break };
        let Some(part) = bench.pane(tab).first_part_of(&bench.problem, &name) else { continue };
        let Some((area, bench)) = view::area_of_pane(model, tab).zip(model.bench.as_ref()) else { continue };
        let page = view::page(model, bench, tab, area.width);
        // The name of the problem stands before its first line.
        let begin = page.starts.get(part).map_or(0, |start| start.saturating_sub(1));
        if let Some(bench) = &mut model.bench {
            bench.scroll[tab.0] = if part == 0 { 0 } else { begin };
        }
    }
    Vec::new()
}

/// Begins a linked problem: of the analysis that the words behind its name name or lead to. A name alone is for the open
/// problem.
pub(super) fn begin_problem(model: &mut Model, words: &str) -> Vec<Intent> {
    let (name, words) = words.trim().split_once(char::is_whitespace).unwrap_or((words.trim(), ""));
    let words = words.trim();
    let Some(bench) = &model.bench else { return Vec::new() };
    let entry = bench.problem.entry();
    if let Err(why) = linked::check_name(entry, name) {
        return ask_again(name, words, why);
    }
    if words.is_empty() {
        if linked::unnamed(entry).is_none() {
            let why =
                "an analysis is needed behind the name, by its id or in words: bracket equivalent stiffness";
            return ask_again(name, words, why.into());
        }
        let said = Text::new("the problem is called {name} now, its answers {name}.…");
        return restructure(model, name, None, said.with("name", name));
    }
    if let Some(entry) = find_analysis(words) {
        return vec![Intent::LinkProblem(name.to_owned(), entry)];
    }
    let analyses: Vec<&Listing> =
        model.listings.iter().filter(|listing| listing.entry.linked().is_empty()).collect();
    let indices: Vec<&search::Index> = analyses.iter().map(|listing| listing.index()).collect();
    let found = search::find(&indices, words);
    match &found[..] {
        [] => ask_again(name, words, Text::new("no analysis is found for `{words}`").with("words", words)),
        [only] => vec![Intent::LinkProblem(name.to_owned(), analyses[only.place].entry)],
        several => {
            let option = |found: &search::Found| {
                let entry = analyses[found.place].entry;
                Choice {
                    label: Text::from(entry.about.title).render(&model.locale.at(entry.about.id)),
                    help: entry.about.id.to_owned(),
                    value: Chosen::Analysis(name.to_owned(), entry),
                }
            };
            let options = several.iter().take(MOST_ANALYSES).map(option).collect();
            vec![Intent::Show(Dialog::Choice { path: String::new(), options, chosen: 0 })]
        }
    }
}

fn ask_again(name: &str, words: &str, why: Text) -> Vec<Intent> {
    let typed = format!("{name} {words}").trim().to_owned();
    vec![Intent::Show(Dialog::prompt_again(Purpose::LinkedProblem, typed, why))]
}

/// Links a blank problem of an analysis under a name; the open one is given the name of its analysis where it has none.
pub(super) fn link_problem(model: &mut Model, name: &str, of: &'static Entry) -> Vec<Intent> {
    let Some(bench) = &model.bench else { return Vec::new() };
    let entry = bench.problem.entry();
    let own = linked::unnamed(entry).map(linked::usual_name);
    let own = own.map(|own| if own == name { own + "_1" } else { own });
    let said = match &own {
        Some(own) => {
            Text::new("linked: the answers of this problem are {name}.…, those of the other {own}.…")
                .with("own", own)
        }
        None => Text::new("linked: the answers of this problem are {name}.…"),
    };
    restructure(model, own.as_deref().unwrap_or(""), Some((name, of)), said.with("name", name))
}

/// Gives the unnamed problem a name, links one more, and shows it.
fn restructure(
    model: &mut Model,
    own: &str,
    more: Option<(&str, &'static Entry)>,
    said: Text,
) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let form = &mut bench.problem.inputs.form;
    form.keep();
    let (entry, draft) = linked::named(form.entry(), &form.draft, own);
    let (entry, draft) = match more {
        Some((name, of)) => linked::with_problem(entry, &draft, name, of),
        None => (entry, draft),
    };
    form.replace(entry, draft);
    let shown = more.map_or(own, |(name, _)| name);
    if let Some(part) = form.parts().into_iter().find(|part| part.name == shown) {
        form.show_part(&part);
    }
    bench.focus = Focus::Form;
    vec![Intent::Changed, Intent::Say(said)]
}

/// Takes the configuration or the linked problem that is shown out of the file.
pub(super) fn remove(model: &mut Model) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let form = &mut bench.problem.inputs.form;
    form.keep();
    let name = form.part().title();
    if !form.remove_part() {
        return Intent::say("only a configuration, or one of several problems, can be removed");
    }
    let said = Text::new("{name} removed; {key} takes that back").with_text("name", name);
    vec![Intent::Changed, Intent::Say(said.with("key", model.key(KeyContext::Form, Action::Undo)))]
}

/// Begins a configuration of the problem that is shown, or shows the one of that name.
pub(super) fn begin_configuration(model: &mut Model, name: &str) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let form = &mut bench.problem.inputs.form;
    form.keep();
    match form.begin_configuration(name.trim()) {
        Ok(is_new) => {
            bench.focus = Focus::Form;
            let said = "what is changed here holds for this configuration alone";
            let new = is_new.then(|| [Intent::Changed, Intent::Say(said.into())]);
            new.into_iter().flatten().collect()
        }
        Err(why) => vec![Intent::Show(Dialog::prompt_again(Purpose::Configuration, name.to_owned(), why))],
    }
}
