//! Design of a study: the inputs of every point, each a function of the number of the point alone.

mod rows;

use std::collections::HashSet;

use dalembert_numerics::{
    distribution::Distribution,
    linalg::symmetric_eigen,
    sampling::{SOBOL_DIMENSIONS, SOBOL_POINTS},
};
use dalembert_units as units;
use nalgebra::DMatrix;

use super::{
    amounts::{amount, shown, unit_of},
    grid::{GridAxis, InputRange},
    indices::INDEPENDENT,
    levels::Levels,
    plan::{Amount, DistributionKind, ReadData, Sampling, Spacing, StudyPlan, Variation},
};
use crate::{
    FieldError, Record, Text,
    vary::{self, VariedInput},
};

/// The most points of a study.
pub(super) const MOST_POINTS: u64 = 1_000_000_000;
/// Samples where a plan says no number.
pub const USUAL_SAMPLES: u64 = 10_000;
/// Eigenvalue of a correlation matrix that rounding may take below zero.
const CORRELATION_ROUNDING: f64 = 1e-12;

/// The inputs of every point of a study.
#[derive(Clone, Debug)]
pub struct Design {
    /// The inputs that vary, in the order of the plan, each in the unit that the plan writes it in.
    pub inputs: Vec<VariedInput>,
    /// Those of the grid, the first one slowest.
    grid: Vec<GridAxis>,
    drawn: Vec<DrawnInput>,
    /// Square root of the correlation matrix of the normal scores; `None` where they are independent.
    correlation: Option<DMatrix<f64>>,
    sampling: Sampling,
    seed: u64,
    samples: u64,
    /// Points of a sample: one, or those of a base sample of Sobol' indices.
    points_of_sample: u64,
    /// Pairs of inputs over which the answers are mapped, by their places.
    pub maps: Vec<[usize; 2]>,
}

/// An input that is drawn from a distribution in its unit.
#[derive(Clone, Debug)]
struct DrawnInput {
    input: usize,
    distribution: Distribution,
}

impl Design {
    /// The design of a plan for a problem. `read_data` reads the CSV files that the plan names.
    ///
    /// # Errors
    /// Everything in the plan that does not fit the problem or contradicts itself.
    pub fn new(plan: &StudyPlan, record: &Record, read_data: &ReadData<'_>) -> Result<Self, Vec<FieldError>> {
        let known = vary::inputs(record);
        let mut reader = Reader { known: &known, read_data, design: Self::empty(plan), errors: Vec::new() };
        for (n, variation) in (1..).zip(&plan.vary) {
            let path = format!("vary[{n}]");
            if let Err(error) = reader.variation(&path, variation) {
                reader.errors.push(error);
            }
        }
        let Reader { mut design, mut errors, .. } = reader;
        if plan.vary.is_empty() {
            let why =
                "name an input that varies: a table [[vary]] with input and values, or from, to and points";
            errors.push(FieldError::new("vary", why));
        }
        let mut seen = HashSet::new();
        for input in &design.inputs {
            if !seen.insert(&input.path) {
                let why = Text::new("{input} varies twice; name it once").with("input", &input.path);
                errors.push(FieldError::new("vary", why));
            }
        }
        if errors.is_empty() {
            errors.extend(design.correlate(plan).err());
            errors.extend(design.read_indices(plan).err());
            errors.extend(design.check_samples(plan).err());
            errors.extend(design.read_maps(plan).err());
        }
        if errors.is_empty() { Ok(design) } else { Err(errors) }
    }

    fn empty(plan: &StudyPlan) -> Self {
        Self {
            inputs: Vec::new(),
            grid: Vec::new(),
            drawn: Vec::new(),
            correlation: None,
            sampling: plan.sampling,
            seed: plan.seed,
            samples: 1,
            points_of_sample: 1,
            maps: Vec::new(),
        }
    }

    /// Number of points.
    pub fn points(&self) -> u64 {
        self.grid.iter().map(GridAxis::len).product::<u64>() * self.samples * self.points_of_sample
    }

    /// Number of points of a base sample; `None` without Sobol' indices.
    pub fn base_sample(&self) -> Option<usize> {
        (self.points_of_sample > 1).then_some(self.points_of_sample as usize)
    }

    /// Levels of every input: the values of a grid, where they are few, or intervals.
    pub fn levels(&self) -> Vec<Levels> {
        let mut levels = vec![Levels::default(); self.inputs.len()];
        for axis in &self.grid {
            match axis {
                GridAxis::Range(range) => {
                    let last = range.points - 1;
                    let ascending = |at| range.value(if range.from <= range.to { at } else { last - at });
                    levels[range.input] = Levels::of_ascending(range.points, ascending);
                }
                GridAxis::Rows { inputs, rows } => {
                    for (n, input) in inputs.iter().enumerate() {
                        levels[*input] = Levels::of_values(rows.iter().map(|row| row[n][0]));
                    }
                }
            }
        }
        for drawn in &self.drawn {
            levels[drawn.input] = Levels::of_distribution(&drawn.distribution);
        }
        levels
    }

    /// The inputs that are drawn from a distribution, by their places.
    pub fn drawn(&self) -> impl Iterator<Item = usize> + '_ {
        self.drawn.iter().map(|drawn| drawn.input)
    }

    /// The axes of the grid, the first one slowest: places of the inputs that run along it, number of points, spacing.
    pub fn axes(&self) -> impl Iterator<Item = (Vec<usize>, u64, Spacing)> + '_ {
        self.grid.iter().map(|axis| match axis {
            GridAxis::Range(range) => (vec![range.input], range.points, range.spacing),
            GridAxis::Rows { inputs, rows } => (inputs.clone(), rows.len() as u64, Spacing::Linear),
        })
    }

    fn check_samples(&mut self, plan: &StudyPlan) -> Result<(), FieldError> {
        if self.drawn.is_empty() {
            if plan.samples.is_some() {
                let why =
                    "samples are drawn of inputs that have a distribution, and none has one; leave it out";
                return Err(FieldError::new("samples", why));
            }
        } else {
            self.samples = plan.samples.unwrap_or(USUAL_SAMPLES);
        }
        if self.samples == 0 {
            return Err(FieldError::new("samples", "write a whole number from 1 on"));
        }
        if self.sampling == Sampling::Sobol {
            // Base samples of Sobol' indices take two dimensions for each input.
            let most = if self.points_of_sample > 1 { SOBOL_DIMENSIONS / 2 } else { SOBOL_DIMENSIONS };
            if self.drawn.len() > most {
                let why = Text::new("the Sobol' sequence serves up to {most} inputs, and {have} are drawn; use latin-hypercube")
                    .with("most", most)
                    .with("have", self.drawn.len());
                return Err(FieldError::new("sampling", why));
            }
            if self.samples > SOBOL_POINTS {
                let why = Text::new("the Sobol' sequence has {most} points; write at most so many samples")
                    .with("most", SOBOL_POINTS);
                return Err(FieldError::new("samples", why));
            }
        }
        let sizes = || {
            let of_sample = [self.points_of_sample].into_iter().filter(|points| *points > 1);
            self.grid.iter().map(GridAxis::len).chain([self.samples]).chain(of_sample)
        };
        let points = sizes().try_fold(1, u64::checked_mul);
        if points.is_none_or(|points| points > MOST_POINTS) {
            let sizes: Vec<String> = sizes().map(|size| size.to_string()).collect();
            let why = Text::new("{sizes} points are more than {most}; write fewer points or samples")
                .with("sizes", sizes.join(" × "))
                .with("most", MOST_POINTS);
            return Err(FieldError::new("vary", why));
        }
        Ok(())
    }

    /// Reads whether Sobol' indices are asked for, which are shares of independent inputs.
    fn read_indices(&mut self, plan: &StudyPlan) -> Result<(), FieldError> {
        if !plan.sobol_indices {
            return Ok(());
        }
        let of_grid = (0..self.inputs.len()).find(|at| !self.drawn().any(|drawn| drawn == *at));
        let why = if let Some(at) = of_grid {
            Text::new("Sobol' indices want a distribution of every input that varies; give {input} one, or leave it at its value in the problem")
                .with("input", &self.inputs[at].path)
        } else if self.correlation.is_some() {
            "Sobol' indices are shares of independent inputs; take the correlations out of the plan, or leave the indices out".into()
        } else {
            self.points_of_sample = (INDEPENDENT + self.drawn.len()) as u64;
            return Ok(());
        };
        Err(FieldError::new("sobol_indices", why))
    }

    /// Reads the pairs of inputs that are mapped.
    fn read_maps(&mut self, plan: &StudyPlan) -> Result<(), FieldError> {
        if plan.map.is_empty() && self.inputs.len() > 1 {
            self.maps.push([0, 1]);
        }
        for (n, map) in (1..).zip(&plan.map) {
            let path = format!("map[{n}].inputs");
            let place = |name: &String| {
                let at = self.inputs.iter().position(|input| input.path == *name);
                at.ok_or_else(|| {
                    let known: Vec<&str> = self.inputs.iter().map(|input| input.path.as_str()).collect();
                    let why = Text::new("`{name}` does not vary in this plan; {known} vary")
                        .with("name", name)
                        .with("known", known.join(", "));
                    FieldError::new(&path, why)
                })
            };
            let [across, upwards] = [place(&map.inputs[0])?, place(&map.inputs[1])?];
            if across == upwards {
                return Err(FieldError::new(path, "write two different inputs"));
            }
            self.maps.push([across, upwards]);
        }
        Ok(())
    }

    fn correlate(&mut self, plan: &StudyPlan) -> Result<(), FieldError> {
        if plan.correlation.is_empty() {
            return Ok(());
        }
        let count = self.drawn.len();
        let mut matrix = DMatrix::identity(count, count);
        for (n, correlation) in (1..).zip(&plan.correlation) {
            let place = |name: &str| {
                let at = self.drawn.iter().position(|drawn| self.inputs[drawn.input].path == name);
                at.ok_or_else(|| {
                    let why = Text::new("`{name}` is not an input with a distribution in this plan")
                        .with("name", name);
                    FieldError::new(format!("correlation[{n}].inputs"), why)
                })
            };
            let [a, b] = &correlation.inputs;
            let (a, b) = (place(a)?, place(b)?);
            let coefficient = correlation.coefficient;
            if a == b || !(-1.0..=1.0).contains(&coefficient) {
                let why = "write two different inputs and a coefficient between -1 and 1";
                return Err(FieldError::new(format!("correlation[{n}]"), why));
            }
            matrix[(a, b)] = coefficient;
            matrix[(b, a)] = coefficient;
        }
        let contradicts = || {
            let why = "these correlations contradict one another: their matrix is not positive definite";
            FieldError::new("correlation", why)
        };
        let eigen = symmetric_eigen(&matrix).map_err(|_| contradicts())?;
        if eigen.values.min() < -CORRELATION_ROUNDING {
            return Err(contradicts());
        }
        let roots = DMatrix::from_diagonal(&eigen.values.map(|value| value.max(0.0).sqrt()));
        self.correlation = Some(&eigen.vectors * roots * eigen.vectors.transpose());
        Ok(())
    }
}

/// Reader of the variations of a plan.
struct Reader<'r> {
    known: &'r [VariedInput],
    read_data: &'r ReadData<'r>,
    design: Design,
    errors: Vec<FieldError>,
}

impl Reader<'_> {
    fn variation(&mut self, path: &str, variation: &Variation) -> Result<(), FieldError> {
        let ways = [
            variation.values.is_some(),
            variation.points.is_some(),
            variation.distribution.is_some(),
            variation.table.is_some(),
        ];
        if ways.iter().filter(|way| **way).count() != 1 {
            let why = "write one of: values; from, to and points; distribution; table";
            return Err(FieldError::new(path, why));
        }
        self.check_parameters(path, variation)?;
        if let Some(file) = &variation.table {
            return self.table(path, file);
        }
        let mut input = self.input(path, variation)?;
        let first = [&variation.from, &variation.mean, &variation.mode].into_iter().flatten().next();
        if let Some(Amount::Text(text)) = variation.values.iter().flatten().next().or(first)
            && let Ok(read) = units::read_quantity(text, &input.unit, input.measure.kind())
        {
            input.unit = read.unit;
        }
        let at = self.design.inputs.len();
        if let Some(values) = &variation.values {
            let row = |(n, value): (usize, &Amount)| {
                let si = amount(&input, &format!("{path}.values[{}]", n + 1), value)?;
                Ok(vec![[shown(&input.unit, si), si]])
            };
            let rows: Vec<_> = values.iter().enumerate().map(row).collect::<Result<_, FieldError>>()?;
            if rows.is_empty() {
                return Err(FieldError::new(
                    format!("{path}.values"),
                    "the list is empty; write at least one value",
                ));
            }
            self.design.grid.push(GridAxis::Rows { inputs: vec![at], rows });
        } else if let Some(points) = variation.points {
            let range = range(path, variation, &input, at, points)?;
            self.design.grid.push(GridAxis::Range(range));
        } else if let Some(kind) = variation.distribution {
            let distribution = self.distribution(path, variation, &input, kind)?;
            self.design.drawn.push(DrawnInput { input: at, distribution });
        }
        self.design.inputs.push(input);
        Ok(())
    }

    /// Refuses a parameter that the way of this variation does not take.
    fn check_parameters(&self, path: &str, variation: &Variation) -> Result<(), FieldError> {
        use DistributionKind::{Data, Lognormal, Normal, Triangular, Uniform};
        let takes: &[&str] = match (&variation.values, &variation.points, variation.distribution) {
            (Some(_), ..) => &["input", "values"],
            (_, Some(_), _) => &["input", "from", "to", "points", "scale"],
            (_, _, Some(Uniform)) => &["input", "distribution", "from", "to", "tolerance"],
            (_, _, Some(Normal | Lognormal)) => &["input", "distribution", "mean", "deviation"],
            (_, _, Some(Triangular)) => &["input", "distribution", "from", "to", "mode"],
            (_, _, Some(Data)) => &["input", "distribution", "data", "column"],
            _ => &["table"],
        };
        let written = [
            ("input", variation.input.is_some()),
            ("from", variation.from.is_some()),
            ("to", variation.to.is_some()),
            ("scale", variation.scale.is_some()),
            ("mean", variation.mean.is_some()),
            ("deviation", variation.deviation.is_some()),
            ("tolerance", variation.tolerance.is_some()),
            ("mode", variation.mode.is_some()),
            ("data", variation.data.is_some()),
            ("column", variation.column.is_some()),
        ];
        match written.iter().find(|(name, is_written)| *is_written && !takes.contains(name)) {
            None => Ok(()),
            Some((name, _)) => {
                let why =
                    Text::new("does not belong here; this way takes {takes}").with("takes", takes.join(", "));
                Err(FieldError::new(format!("{path}.{name}"), why))
            }
        }
    }

    fn input(&self, path: &str, variation: &Variation) -> Result<VariedInput, FieldError> {
        let path = format!("{path}.input");
        let Some(name) = &variation.input else {
            return Err(FieldError::new(path, "name the input that varies"));
        };
        self.find(&path, name)
    }

    fn find(&self, path: &str, name: &str) -> Result<VariedInput, FieldError> {
        let of_symbol = || {
            let mut all = self.known.iter().filter(|known| known.symbol == name);
            all.next().filter(|_| all.next().is_none())
        };
        let found = self.known.iter().find(|known| known.path == name).or_else(of_symbol);
        found.cloned().ok_or_else(|| FieldError::new(path, vary::unknown_number(self.known, name)))
    }

    fn table(&mut self, path: &str, file: &str) -> Result<(), FieldError> {
        let path = format!("{path}.table");
        let columns = (self.read_data)(file).map_err(|why| FieldError::new(&path, why))?;
        let first = self.design.inputs.len();
        let mut numbers = Vec::new();
        for column in columns {
            let input = self.find(&path, &column.name)?;
            let input = VariedInput { unit: unit_of(&path, &column, &input)?, ..input };
            numbers
                .push(column.numbers.iter().map(|shown| [*shown, input.unit.si(*shown)]).collect::<Vec<_>>());
            self.design.inputs.push(input);
        }
        let count = numbers.first().map_or(0, Vec::len);
        if count == 0 {
            return Err(FieldError::new(path, Text::new("{file} has no rows").with("file", file)));
        }
        let rows = (0..count).map(|row| numbers.iter().map(|column| column[row]).collect()).collect();
        let inputs = (first..self.design.inputs.len()).collect();
        self.design.grid.push(GridAxis::Rows { inputs, rows });
        Ok(())
    }

    fn distribution(
        &self,
        path: &str,
        variation: &Variation,
        input: &VariedInput,
        kind: DistributionKind,
    ) -> Result<Distribution, FieldError> {
        let own = shown(&input.unit, input.si);
        let read = |name: &str, value: &Option<Amount>| {
            let path = format!("{path}.{name}");
            let value =
                value.as_ref().ok_or_else(|| FieldError::new(&path, "is missing for this distribution"))?;
            amount(input, &path, value).map(|si| shown(&input.unit, si))
        };
        let or_own = |name: &str, value: &Option<Amount>| match value {
            None => Ok(own),
            value => read(name, value),
        };
        // A width may be a share of the value: `2 %`.
        let width = |name: &str, value: &Option<Amount>, of: f64| {
            let path = format!("{path}.{name}");
            let about = VariedInput { si: input.unit.si(of), ..input.clone() };
            let si = match value {
                None => return Err(FieldError::new(path, "is missing for this distribution")),
                Some(Amount::Number(number)) => input.unit.si(*number),
                Some(Amount::Text(text)) => {
                    about.tolerance(text).map_err(|why| FieldError::new(&path, why))?
                }
            };
            let width = input.unit.value(si);
            if width > 0.0 && width.is_finite() {
                Ok(width)
            } else {
                Err(FieldError::new(path, "must be above zero"))
            }
        };
        let distribution = match kind {
            DistributionKind::Uniform if variation.tolerance.is_some() => {
                let half = width("tolerance", &variation.tolerance, own)?;
                Distribution::uniform(own - half, own + half)
            }
            DistributionKind::Uniform => {
                Distribution::uniform(read("from", &variation.from)?, read("to", &variation.to)?)
            }
            DistributionKind::Normal => {
                let mean = or_own("mean", &variation.mean)?;
                Distribution::normal(mean, width("deviation", &variation.deviation, mean)?)
            }
            DistributionKind::Lognormal => {
                let mean = or_own("mean", &variation.mean)?;
                Distribution::lognormal(mean, width("deviation", &variation.deviation, mean)?)
            }
            DistributionKind::Triangular => Distribution::triangular(
                read("from", &variation.from)?,
                or_own("mode", &variation.mode)?,
                read("to", &variation.to)?,
            ),
            DistributionKind::Data => Distribution::of_data(self.data(path, variation, input)?),
        };
        distribution.ok_or_else(|| {
            let why = match kind {
                DistributionKind::Uniform => "`from` must be below `to`",
                DistributionKind::Triangular => {
                    "`from`, `mode` and `to` must ascend, and `from` be below `to`"
                }
                DistributionKind::Lognormal => "the mean of a lognormal distribution must be above zero",
                DistributionKind::Normal => "mean and deviation must be finite",
                DistributionKind::Data => "at least two values are needed to draw from",
            };
            FieldError::new(path, why)
        })
    }

    fn data(&self, path: &str, variation: &Variation, input: &VariedInput) -> Result<Vec<f64>, FieldError> {
        let path = format!("{path}.data");
        let Some(file) = &variation.data else {
            return Err(FieldError::new(path, "name the CSV file of the measured values"));
        };
        let columns = (self.read_data)(file).map_err(|why| FieldError::new(&path, why))?;
        let name = variation.column.as_deref().unwrap_or(&input.path);
        let column = match &columns[..] {
            [only] if variation.column.is_none() => Some(only),
            all => all.iter().find(|column| column.name == name),
        };
        let Some(column) = column else {
            let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
            let why = Text::new("{file} has no column `{name}`; it has {known}")
                .with("file", file)
                .with("name", name)
                .with("known", names.join(", "));
            return Err(FieldError::new(path, why));
        };
        let unit = unit_of(&path, column, input)?;
        Ok(column.numbers.iter().map(|number| input.unit.value(unit.si(*number))).collect())
    }
}

fn range(
    path: &str,
    variation: &Variation,
    input: &VariedInput,
    at: usize,
    points: u64,
) -> Result<InputRange, FieldError> {
    let end = |name: &str, value: &Option<Amount>| {
        let path = format!("{path}.{name}");
        let value = value.as_ref().ok_or_else(|| FieldError::new(&path, "is missing for this range"))?;
        amount(input, &path, value).map(|si| shown(&input.unit, si))
    };
    let (from, to) = (end("from", &variation.from)?, end("to", &variation.to)?);
    let spacing = variation.scale.unwrap_or_default();
    if spacing == Spacing::Log && !(from > 0.0 && to > 0.0) {
        return Err(FieldError::new(
            path,
            "a logarithmic range lies above zero; write other ends or scale = \"linear\"",
        ));
    }
    if points == 0 || points == 1 && from != to {
        return Err(FieldError::new(format!("{path}.points"), "write a whole number from 2 on"));
    }
    Ok(InputRange { input: at, from, to, points, spacing })
}
