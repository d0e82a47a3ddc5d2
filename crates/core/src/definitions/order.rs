//! Order of evaluation: each definition, input, solution and question behind what it rests on.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use dalembert_units as units;

use super::{
    Plan,
    names::{Named, Place},
    questions,
    scope::TOP,
};
use crate::{FieldError, Text, formula::Formula};

impl Plan {
    /// Adds the inputs that formulas name.
    pub(super) fn add_named_inputs(&mut self) {
        let mut named = Vec::new();
        let places = (0..self.definitions.len()).map(Place::Definition);
        for place in places.chain((0..self.inputs.len()).map(Place::Input)).collect::<Vec<_>>() {
            for (name, _) in self.formula_of(place).map(Formula::names).unwrap_or_default() {
                if let Some(Named::Input(path)) = self.find(place, name) {
                    named.push(path);
                }
            }
        }
        for path in named {
            if self.inputs.iter().all(|input| input.path != path)
                && let Some(input) = self.names.input(&path)
            {
                self.inputs.push(input);
            }
        }
    }

    /// Finds the order of evaluation.
    pub(super) fn arrange(&mut self) -> Result<(), FieldError> {
        self.before_solution = self.before_solution();
        self.meanings = Arc::new(self.meanings());
        let (mut order, mut open, mut begun) = (Vec::new(), Vec::new(), BTreeSet::new());
        let scopes = &self.names.scopes;
        let (problems, configurations): (Vec<usize>, Vec<usize>) =
            (0..scopes.len()).partition(|scope| scopes[*scope].problem == *scope);
        for scope in problems.into_iter().chain(configurations) {
            self.visit_scope(scope, &mut order, &mut open, &mut begun)?;
        }
        for at in 0..self.questions.len() {
            self.visit(Place::Question(at), &mut order, &mut open)?;
        }
        self.order = order;
        for place in self.order.clone() {
            let rests = |on: &Place| {
                matches!(on, Place::Solution(_) | Place::Question(_)) || self.after_solution.contains(on)
            };
            if self.needs(place).iter().any(rests) {
                self.after_solution.insert(place);
            }
        }
        Ok(())
    }

    /// Visits a problem with its questions, whole, behind those whose answers it rests on, where they can come first.
    /// The questions of the file itself come at its end.
    fn visit_scope(
        &self,
        scope: usize,
        order: &mut Vec<Place>,
        open: &mut Vec<Place>,
        begun: &mut BTreeSet<usize>,
    ) -> Result<(), FieldError> {
        if !begun.insert(scope) {
            return Ok(());
        }
        let definitions = (0..self.definitions.len()).map(Place::Definition);
        let inputs = (0..self.inputs.len()).map(Place::Input);
        let questions = (0..self.questions.len()).map(Place::Question).filter(|_| scope != TOP);
        let all = definitions.chain(inputs).chain([Place::Solution(scope)]).chain(questions);
        let own: Vec<Place> = all.filter(|place| self.scope_of(*place) == scope).collect();
        for on in own.iter().flat_map(|place| self.needs(*place)) {
            if matches!(on, Place::Solution(_) | Place::Question(_)) {
                self.visit_scope(self.scope_of(on), order, open, begun)?;
            }
        }
        own.into_iter().try_for_each(|place| self.visit(place, order, open))
    }

    pub(super) fn scope_of(&self, place: Place) -> usize {
        match place {
            Place::Definition(at) => self.definitions[at].scope,
            Place::Input(at) => self.inputs[at].scope,
            Place::Solution(scope) => scope,
            Place::Question(at) => self.questions[at].scope,
        }
    }

    /// Places that a place rests on itself.
    fn needs(&self, place: Place) -> Vec<Place> {
        let names = self.formula_of(place).map(Formula::names).unwrap_or_default();
        let named = names.into_iter().filter_map(|(name, _)| self.find(place, name));
        let mut needs: Vec<Place> = named.filter_map(|named| self.place(&named)).collect();
        match place {
            Place::Solution(scope) => {
                let problem = self.names.scopes[scope].problem;
                let of = |input: &super::PlannedInput| [scope, problem].contains(&input.scope);
                let inputs = (0..self.inputs.len()).filter(|at| of(&self.inputs[*at]));
                needs.extend(inputs.map(Place::Input));
                // A configuration is shown behind the problem that it changes.
                needs.extend((problem != scope).then_some(Place::Solution(problem)));
            }
            Place::Question(at) => needs.push(Place::Solution(self.questions[at].scope)),
            Place::Definition(_) | Place::Input(_) => {}
        }
        needs
    }

    fn visit(&self, place: Place, order: &mut Vec<Place>, open: &mut Vec<Place>) -> Result<(), FieldError> {
        if order.contains(&place) {
            return Ok(());
        }
        if let Some(start) = open.iter().position(|before| *before == place) {
            let named = open[start..].iter().chain([&place]).map(|place| self.name_of(*place));
            let circle: Vec<String> = named.filter(|name| !name.is_empty()).collect();
            let why = Text::new("defined in a circle: {circle}").with("circle", circle.join(" → "));
            let at = open[start..].iter().find(|place| self.formula_of(**place).is_some());
            return Err(FieldError::new(self.path_of(*at.unwrap_or(&place)), why));
        }
        open.push(place);
        for on in self.needs(place) {
            self.visit(on, order, open)?;
        }
        open.pop();
        order.push(place);
        Ok(())
    }

    /// The scope whose names the formula of a place can use: one of a configuration sees the problem that it changes.
    pub(super) fn scope_of_formula(&self, place: Place) -> usize {
        match place {
            Place::Input(at) => self.names.scopes[self.inputs[at].scope].problem,
            place => self.scope_of(place),
        }
    }

    /// Meaning of a name in the formula of a place.
    pub(super) fn find(&self, place: Place, name: &str) -> Option<Named> {
        let known = self.meanings.get(&place).into_iter().flatten().find(|(known, _)| known == name);
        known.map_or_else(|| self.looked_up(place, name), |(_, named)| named.clone())
    }

    /// A word in a definition that is nothing before the solution, nor a unit, is an answer, unless an input needs it.
    fn looked_up(&self, place: Place, name: &str) -> Option<Named> {
        let scope = self.scope_of_formula(place);
        self.names.find(scope, name).or_else(|| {
            let is_later = matches!(place, Place::Definition(at) if !self.before_solution.contains(&at));
            (is_later && self.names.has_analysis(scope) && units::unit(name).is_err())
                .then(|| Named::Answer(scope, name.to_owned()))
        })
    }

    /// The definitions that inputs of their own problem rest on.
    fn before_solution(&self) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        let mut open: Vec<Place> = (0..self.inputs.len()).map(Place::Input).collect();
        while let Some(place) = open.pop() {
            let scope = self.scope_of_formula(place);
            for (name, _) in self.formula_of(place).map(Formula::names).unwrap_or_default() {
                if let Some(Named::Definition(at)) = self.names.find(scope, name)
                    && [scope, TOP].contains(&self.definitions[at].scope)
                    && found.insert(at)
                {
                    open.push(Place::Definition(at));
                }
            }
        }
        found
    }

    /// Meanings of the names in each formula, so that a formula that is evaluated again does not look them up.
    fn meanings(&self) -> BTreeMap<Place, Vec<(String, Option<Named>)>> {
        let definitions = (0..self.definitions.len()).map(Place::Definition);
        let inputs = (0..self.inputs.len()).map(Place::Input);
        let questions = (0..self.questions.len()).map(Place::Question);
        let meanings = definitions.chain(inputs).chain(questions).filter_map(|place| {
            let names = self.formula_of(place)?.names();
            let meaning = |(name, _): (&str, _)| (name.to_owned(), self.looked_up(place, name));
            Some((place, names.into_iter().map(meaning).collect()))
        });
        meanings.collect()
    }

    /// The place that a name leads to: of an answer, the solution that it is of.
    pub(super) fn place(&self, named: &Named) -> Option<Place> {
        match named {
            Named::Input(path) => self.inputs.iter().position(|input| input.path == *path).map(Place::Input),
            Named::Definition(at) => Some(Place::Definition(*at)),
            Named::Question(at) => Some(Place::Question(*at)),
            Named::Answer(scope, _) => Some(Place::Solution(*scope)),
        }
    }

    pub(super) fn formula_of(&self, place: Place) -> Option<&Formula> {
        match place {
            Place::Definition(at) => Some(&self.definitions[at].formula),
            Place::Input(at) => self.inputs[at].formula.as_ref(),
            Place::Solution(_) => None,
            Place::Question(at) => Some(&self.questions[at].formula),
        }
    }

    /// Name of a place from outside.
    fn name_of(&self, place: Place) -> String {
        match place {
            Place::Definition(at) => self.outside(&self.definitions[at]),
            Place::Input(at) => self.inputs[at].path.clone(),
            Place::Solution(scope) => self.names.scopes[scope].name.to_owned(),
            Place::Question(at) => {
                self.names.scopes[self.questions[at].scope].outside(&self.questions[at].key)
            }
        }
    }

    /// The path that an error of a formula is reported at.
    pub(super) fn path_of(&self, place: Place) -> String {
        match place {
            Place::Definition(at) => self.path_of_definition(&self.definitions[at]),
            Place::Input(at) => self.inputs[at].error_path.clone(),
            Place::Solution(_) => String::new(),
            Place::Question(at) => questions::path(self, at),
        }
    }
}
