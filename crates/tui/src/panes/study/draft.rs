//! A plan as it is typed: texts, of which an empty one stands for what is usual.

use dalembert_core::{
    FieldError, Text,
    study::{
        Amount, Correlation, DistributionKind, Limit, MappedInputs, Sampling, Spacing, StudyPlan,
        USUAL_SAMPLES, Variation,
    },
    vary::VariedInput,
};
use dalembert_units::{Style, write_number, write_quantity};

use super::kind::Kind;

/// Points of a curve, unless the user says otherwise.
const POINTS: u64 = 201;
/// The ends of the range of an input, unless the user says otherwise, as shares of what it is.
const RANGE: [f64; 2] = [0.5, 1.5];
/// Those of a range with equal ratios.
const LOG_RANGE: [f64; 2] = [0.1, 10.0];
/// The values of a list, unless the user says otherwise, as shares of what the input is.
const LIST: [f64; 3] = [0.5, 1.0, 2.0];
/// Ends and peak of a triangular distribution.
const TRIANGLE: [f64; 3] = [0.9, 1.0, 1.1];
/// Samples, unless the user says otherwise.
pub(super) const SAMPLES: &str = "2000";
/// Seed of the samples, unless the user says otherwise.
pub(super) const SEED: &str = "1";
/// Texts are written as in a file.
const STYLE: Style = Style { digits: 5, decimal: dalembert_units::Decimal::Point, ascii: true };

/// A plan as it is typed.
#[derive(Clone, Debug, Default)]
pub(super) struct Draft {
    /// The inputs that vary.
    pub(super) vary: Vec<Varied>,
    /// Correlations.
    pub(super) correlation: Vec<String>,
    /// Limits.
    pub(super) limit: Vec<String>,
    /// Conditions.
    pub(super) condition: Vec<String>,
    /// Method by which samples are drawn.
    pub(super) sampling: Sampling,
    /// Number of samples.
    pub(super) samples: String,
    /// Seed of the samples.
    pub(super) seed: String,
    /// The maps of the plan, which the pane does not show.
    pub(super) maps: Vec<MappedInputs>,
    /// True if the plan asks for Sobol' indices, which the pane does not show.
    pub(super) sobol_indices: bool,
}

/// An input that varies, or the inputs of a table.
#[derive(Clone, Debug)]
pub(super) struct Varied {
    /// The path of the input; `None` of a table.
    pub(super) input: Option<String>,
    /// The line.
    pub(super) text: String,
    /// The line and its variation as they came from a file.
    opened: Option<(String, Variation)>,
}

/// Way in which an input varies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    Range,
    LogRange,
    List,
    Uniform,
    Normal,
    Triangular,
    Lognormal,
    Data,
}

impl Way {
    /// Every way, with its name.
    pub(super) const ALL: [(Way, &str); 8] = [
        (Way::Range, "range, linear"),
        (Way::LogRange, "range, logarithmic"),
        (Way::List, "list of values"),
        (Way::Uniform, "uniform within a tolerance"),
        (Way::Normal, "normal, by its standard deviation"),
        (Way::Triangular, "triangular: least, most probable and largest value"),
        (Way::Lognormal, "lognormal, by its standard deviation"),
        (Way::Data, "measured values in a CSV file"),
    ];

    /// The line of an input with the usual numbers; empty where it cannot vary so. `tolerance` is typed, or that of
    /// the input.
    pub(super) fn line(self, input: &VariedInput, tolerance: &str) -> String {
        let text = |share: f64| write_quantity(part(input, share), &input.unit, STYLE);
        let amount = |share: f64| Some(Amount::Text(text(share)));
        let range = |[from, to]: [f64; 2], scale| Variation {
            from: amount(from),
            to: amount(to),
            points: Some(POINTS),
            scale,
            ..Variation::default()
        };
        let several = |shares: [f64; 3]| shares.map(text).join("; ");
        match self {
            Way::Range => range(RANGE, None).line(""),
            Way::LogRange if input.si > 0.0 => range(LOG_RANGE, Some(Spacing::Log)).line(""),
            Way::List => several(LIST),
            Way::Uniform => format!("uniform({tolerance})"),
            Way::Normal => format!("normal({tolerance})"),
            Way::Triangular if input.si > 0.0 => format!("triangular({})", several(TRIANGLE)),
            Way::Lognormal if input.si > 0.0 => format!("lognormal({tolerance})"),
            Way::Data => "data(values.csv)".to_owned(),
            _ => String::new(),
        }
    }
}

impl Varied {
    /// An input with its line.
    pub(super) fn new(input: &str, text: String) -> Self {
        Self { input: Some(input.to_owned()), text, opened: None }
    }

    /// The inputs of a table.
    pub(super) fn table(text: &str) -> Self {
        Self { input: None, text: text.to_owned(), opened: None }
    }

    /// The variation; `usual` is the line of an empty text.
    fn read(&self, usual: &str) -> Option<Variation> {
        if let Some((text, variation)) = &self.opened
            && *text == self.text
        {
            return Some(variation.clone());
        }
        let text = if self.text.trim().is_empty() { usual } else { &self.text };
        let input = self.input.as_deref();
        // A range without a number of points has the usual one.
        Variation::read(input, text)
            .or_else(|| Variation::read(input, &format!("{text}:{POINTS}")).filter(|_| text.contains("..")))
    }

    /// True if its values are drawn from a distribution.
    pub(super) fn is_drawn(&self, usual: &str) -> bool {
        self.read(usual).is_some_and(|variation| variation.distribution.is_some())
    }
}

impl Draft {
    /// The plan of a file.
    pub(super) fn of(plan: &StudyPlan, inputs: &[VariedInput]) -> Self {
        let varied = |variation: &Variation| {
            let path = variation.input.as_deref();
            let input = inputs.iter().find(|input| path == Some(&input.path));
            let text = variation.line(&input.map_or_else(String::new, |input| input.unit.ascii()));
            let opened = Some((text.clone(), variation.clone()));
            Varied { input: variation.input.clone(), text, opened }
        };
        Self {
            vary: plan.vary.iter().map(varied).collect(),
            correlation: plan.correlation.iter().map(Correlation::line).collect(),
            limit: plan.limit.iter().map(Limit::line).collect(),
            condition: plan.condition.iter().map(Limit::line).collect(),
            sampling: plan.sampling,
            samples: plan.samples.unwrap_or(USUAL_SAMPLES).to_string(),
            seed: plan.seed.to_string(),
            maps: plan.map.clone(),
            sobol_indices: plan.sobol_indices,
        }
    }

    /// The plan for these answers. `usual` is the line of each input whose text is empty.
    ///
    /// # Errors
    /// Every text that cannot be read, by its place in a plan.
    pub(super) fn read(&self, answers: &[String], usual: &[String]) -> Result<StudyPlan, Vec<FieldError>> {
        let mut errors = Vec::new();
        let mut plan = StudyPlan {
            answers: answers.to_vec(),
            sampling: self.sampling,
            map: self.maps.clone(),
            sobol_indices: self.sobol_indices,
            ..StudyPlan::default()
        };
        if self.vary.is_empty() {
            errors.push(FieldError::new("vary", "no input varies; add one"));
        }
        for (n, (varied, usual)) in (1..).zip(self.vary.iter().zip(usual)) {
            match varied.read(usual) {
                Some(variation) => plan.vary.push(variation),
                None => errors.push(FieldError::new(
                    format!("vary[{n}]"),
                    "write a range `1..9 mm:5`, a list `1 mm; 3 mm`, or a distribution, as in `normal(2 %)`",
                )),
            }
        }
        plan.correlation = texts(
            "correlation",
            &self.correlation,
            Correlation::read,
            &mut errors,
            || "write two inputs and their coefficient, as in `mass; speed: 0.5`",
        );
        let of_limit = || "write an answer and a value, as in `amplitude > 0.2 mm`";
        plan.limit = texts("limit", &self.limit, Limit::read, &mut errors, of_limit);
        plan.condition = texts("condition", &self.condition, Limit::read, &mut errors, of_limit);
        let mut whole = |path: &str, text: &str, usual: &str| {
            let text = if text.trim().is_empty() { usual } else { text.trim() };
            let number = text.parse::<u64>().ok();
            if number.is_none() {
                errors.push(FieldError::new(path, "enter a whole number"));
            }
            number.unwrap_or_default()
        };
        let is_drawn = self.is_drawn(usual);
        if is_drawn {
            plan.samples = Some(whole("samples", &self.samples, SAMPLES));
        }
        if is_drawn || !self.seed.trim().is_empty() {
            plan.seed = whole("seed", &self.seed, SEED);
        }
        if errors.is_empty() { Ok(plan) } else { Err(errors) }
    }

    /// True if an input is drawn from a distribution.
    pub(super) fn is_drawn(&self, usual: &[String]) -> bool {
        self.vary.iter().zip(usual).any(|(varied, usual)| varied.is_drawn(usual))
    }
}

/// The usual line of an input in a study of a kind. `typed` is its tolerance where the user typed one.
pub(super) fn usual(kind: Kind, input: &VariedInput, typed: &str) -> String {
    let tolerance = if typed.trim().is_empty() { input.step_text() } else { typed.trim() };
    match kind {
        Kind::Sweep | Kind::Find | Kind::File => Way::Range.line(input, tolerance),
        Kind::Uniform => Way::Uniform.line(input, tolerance),
        Kind::Normal => match input.tolerance(tolerance) {
            Ok(width) => Way::Normal.line(input, &share(input, width / 3.0)),
            Err(_) => Way::Normal.line(input, tolerance),
        },
    }
}

/// A width as a share of an input, or in its unit where it is an angle.
fn share(input: &VariedInput, width: f64) -> String {
    if input.step_text().ends_with('%') && input.si != 0.0 {
        return format!("{} %", write_number(100.0 * width / input.si.abs(), STYLE));
    }
    write_quantity(width, &input.unit, STYLE)
}

/// An input that is so large a share of what it is; of one that is zero, off by that share of its unit to both sides, or
/// from zero on where it cannot be negative.
fn part(input: &VariedInput, share: f64) -> f64 {
    if input.si != 0.0 {
        return share * input.si;
    }
    let least = (RANGE[0] - 1.0) * input.unit.factor;
    let zero = if input.permits(least) { 1.0 } else { RANGE[0] };
    (share - zero) * input.unit.factor
}

/// The usual line of a limit of an answer: its present value.
pub(super) fn limit_line(answer: &dalembert_core::Answer, sign: char) -> String {
    let value = write_quantity(answer.si().unwrap_or_default(), &answer.unit, STYLE);
    format!("{} {sign} {value}", answer.name)
}

/// True if a distribution of a variation needs a file.
pub(super) fn names_a_file(text: &str) -> bool {
    Variation::read(Some(""), text)
        .is_some_and(|variation| variation.distribution == Some(DistributionKind::Data))
        || Variation::read(None, text).is_some()
}

fn texts<T>(
    list: &str,
    texts: &[String],
    read: impl Fn(&str) -> Option<T>,
    errors: &mut Vec<FieldError>,
    why: impl Fn() -> &'static str,
) -> Vec<T> {
    let mut found = Vec::new();
    for (n, text) in (1..).zip(texts) {
        match read(text) {
            Some(one) => found.push(one),
            None => errors.push(FieldError::new(format!("{list}[{n}]"), Text::new(why()))),
        }
    }
    found
}
