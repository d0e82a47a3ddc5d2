//! Variations, limits and correlations of a plan as lines: those of the command line and of the workbench.
//!
//! | line | how the input varies |
//! |---|---|
//! | `600..1800 rpm:13` | range of 13 values |
//! | `1..1000 N/m:31:log` | the same with equal ratios |
//! | `40 kg; 45 kg` | list |
//! | `uniform(2 %)`, `uniform(38 kg; 42 kg)` | uniform within a tolerance, or from and to |
//! | `normal(2 %)`, `normal(40 kg; 1 kg)` | normal: standard deviation, or mean and standard deviation |
//! | `lognormal(2 %)`, `lognormal(40 kg; 1 kg)` | lognormal, by those of the quantity itself |
//! | `triangular(38 kg; 45 kg)`, `triangular(38 kg; 40 kg; 45 kg)` | triangular: from, peak, to |
//! | `data(mass.csv)`, `data(mass.csv; mass)` | measured values in a file, and their column |
//! | `table(points.csv)` | rows of a file, whose headings are inputs |

use super::plan::{Amount, Correlation, DistributionKind, Limit, Spacing, Variation};

impl Variation {
    /// Reads the line of an input; without one, that of a table. `None` where it is no such line.
    pub fn read(input: Option<&str>, values: &str) -> Option<Self> {
        use DistributionKind::{Data, Lognormal, Normal, Triangular, Uniform};
        let values = values.trim();
        let Some(input) = input else {
            let table = values.strip_prefix("table(")?.strip_suffix(')')?.trim();
            return (!table.is_empty())
                .then(|| Variation { table: Some(table.to_owned()), ..Variation::default() });
        };
        let variation = Variation { input: Some(input.to_owned()), ..Variation::default() };
        if let Some((name, parameters)) = values.strip_suffix(')').and_then(|values| values.split_once('(')) {
            let parameters: Vec<&str> = parameters.split(';').map(str::trim).collect();
            let kind = KINDS.iter().find(|(_, known)| *known == name.trim())?.0;
            let drawn = Variation { distribution: Some(kind), ..variation };
            let text = |text: &&str| Some((*text).to_owned()).filter(|text| !text.is_empty());
            return Some(match (kind, &parameters[..]) {
                (Normal | Lognormal, [deviation]) => Variation { deviation: width(deviation), ..drawn },
                (Normal | Lognormal, [mean, deviation]) => {
                    Variation { mean: amount(mean), deviation: width(deviation), ..drawn }
                }
                (Uniform, [tolerance]) => Variation { tolerance: width(tolerance), ..drawn },
                (Uniform | Triangular, [from, to]) => {
                    let [from, to] = range(from, to);
                    Variation { from, to, ..drawn }
                }
                (Triangular, [from, mode, to]) => {
                    Variation { from: amount(from), mode: amount(mode), to: amount(to), ..drawn }
                }
                (Data, [file]) => Variation { data: text(file), ..drawn },
                (Data, [file, column]) => Variation { data: text(file), column: text(column), ..drawn },
                _ => return None,
            });
        }
        if let Some((from, rest)) = values.split_once("..") {
            let mut parts = rest.split(':').map(str::trim);
            let to = parts.next()?;
            let points = parts.next()?.parse().ok()?;
            let scale = match parts.next() {
                None => None,
                Some("log") => Some(Spacing::Log),
                Some("linear") => Some(Spacing::Linear),
                Some(_) => return None,
            };
            let [from, to] = range(from.trim(), to);
            return Some(Variation { from, to, points: Some(points), scale, ..variation });
        }
        let list: Option<Vec<Amount>> = values.split(';').map(amount).collect();
        Some(Variation { values: Some(list?), ..variation })
    }

    /// Line that reads as this variation. `unit` is that of its input, for numbers without one where they need it.
    pub fn line(&self, unit: &str) -> String {
        let written = |amount: &Option<Amount>| amount.as_ref().map(Amount::text);
        if let Some(values) = &self.values {
            return values.iter().map(Amount::text).collect::<Vec<_>>().join("; ");
        }
        if let Some(table) = &self.table {
            return format!("table({table})");
        }
        if let Some(points) = self.points {
            let [from, to] = ends(self.from.as_ref(), self.to.as_ref(), unit);
            let scale = match self.scale {
                None => "",
                Some(Spacing::Linear) => ":linear",
                Some(Spacing::Log) => ":log",
            };
            return format!("{from}..{to}:{points}{scale}");
        }
        let Some(kind) = self.distribution else { return String::new() };
        // A width alone is a share: a number of the file is in the unit of what it is the width of.
        let own = written(&self.mean).map(|mean| unit_of(&mean).trim().to_owned());
        let own = own.filter(|own| !own.is_empty()).unwrap_or_else(|| unit.to_owned());
        let width = |amount: &Option<Amount>| match amount {
            Some(Amount::Number(number)) => Some(format!("{number} {own}").trim_end().to_owned()),
            other => written(other),
        };
        let parameters: Vec<Option<String>> = match kind {
            DistributionKind::Uniform if self.tolerance.is_some() => vec![width(&self.tolerance)],
            DistributionKind::Uniform | DistributionKind::Triangular => {
                vec![written(&self.from), written(&self.mode), written(&self.to)]
            }
            DistributionKind::Normal | DistributionKind::Lognormal => {
                vec![written(&self.mean), width(&self.deviation)]
            }
            DistributionKind::Data => vec![self.data.clone(), self.column.clone()],
        };
        let name = KINDS.iter().find(|(known, _)| *known == kind).map_or("", |(_, name)| name);
        format!("{name}({})", parameters.into_iter().flatten().collect::<Vec<_>>().join("; "))
    }
}

impl Limit {
    /// Reads `ANSWER > VALUE`, `ANSWER < VALUE`, or both: `ANSWER > 9 mm; < 2 mm`. `None` where it is no such line.
    pub fn read(text: &str) -> Option<Self> {
        let (answer, rest) = text.split_at(text.find(['>', '<'])?);
        let mut limit = Limit { answer: answer.trim().to_owned(), above: None, below: None };
        for part in rest.split(';').map(str::trim) {
            let (place, value) = match (part.strip_prefix('>'), part.strip_prefix('<')) {
                (Some(value), _) => (&mut limit.above, value),
                (_, Some(value)) => (&mut limit.below, value),
                _ => return None,
            };
            if place.replace(amount(value)?).is_some() {
                return None;
            }
        }
        (!limit.answer.is_empty()).then_some(limit)
    }

    /// Line that reads as this limit.
    pub fn line(&self) -> String {
        let part = |sign: char, amount: &Amount| format!("{sign} {}", amount.text());
        let above = self.above.iter().map(|amount| part('>', amount));
        let parts: Vec<String> = above.chain(self.below.iter().map(|amount| part('<', amount))).collect();
        format!("{} {}", self.answer, parts.join("; ")).trim_end().to_owned()
    }
}

impl Correlation {
    /// Reads `INPUT; INPUT: COEFFICIENT`. `None` where it is no such line.
    pub fn read(text: &str) -> Option<Self> {
        let (inputs, coefficient) = text.rsplit_once(':')?;
        let (one, other) = inputs.split_once(';')?;
        let coefficient = coefficient.trim().replace(',', ".").replace('−', "-").parse().ok()?;
        let inputs = [one, other].map(|input| input.trim().to_owned());
        inputs.iter().all(|input| !input.is_empty()).then_some(Self { inputs, coefficient })
    }

    /// Line that reads as this correlation.
    pub fn line(&self) -> String {
        let [one, other] = &self.inputs;
        format!("{one}; {other}: {}", self.coefficient)
    }
}

impl Amount {
    /// The amount as it is typed.
    fn text(&self) -> String {
        match self {
            Amount::Number(number) => number.to_string(),
            Amount::Text(text) => text.clone(),
        }
    }
}

/// Names of the distributions.
const KINDS: [(DistributionKind, &str); 5] = [
    (DistributionKind::Uniform, "uniform"),
    (DistributionKind::Normal, "normal"),
    (DistributionKind::Triangular, "triangular"),
    (DistributionKind::Lognormal, "lognormal"),
    (DistributionKind::Data, "data"),
];

/// An amount, as a number where it has no unit; `None` of an empty text.
fn amount(text: &str) -> Option<Amount> {
    let text = text.trim();
    let number = text.parse().ok().filter(|number: &f64| number.is_finite());
    number.map(Amount::Number).or_else(|| width(text))
}

/// A width, which alone is a share in percent; `None` of an empty text.
fn width(text: &str) -> Option<Amount> {
    (!text.is_empty()).then(|| Amount::Text(text.to_owned()))
}

/// The ends of a range; `600..1800 rpm` has the unit of its end on both sides.
fn range(from: &str, to: &str) -> [Option<Amount>; 2] {
    let is_alone = !from.is_empty() && unit_of(from).is_empty();
    [if is_alone { amount(&format!("{from}{}", unit_of(to))) } else { amount(from) }, amount(to)]
}

/// The ends of a range as they are typed, with a unit that both have written once.
fn ends(from: Option<&Amount>, to: Option<&Amount>, unit: &str) -> [String; 2] {
    let text = |amount: Option<&Amount>| amount.map_or_else(String::new, Amount::text);
    let (first, last) = (text(from), text(to));
    let common = unit_of(&last);
    match first.strip_suffix(common) {
        _ if common.is_empty() => [first, last],
        Some(number) if unit_of(number).is_empty() => [number.to_owned(), last],
        // A number alone would take the unit of the end.
        _ if matches!(from, Some(Amount::Number(_))) => [format!("{first} {unit}"), last],
        _ => [first, last],
    }
}

/// Unit behind the number of a quantity, with the space before it.
fn unit_of(text: &str) -> &str {
    text.trim_start_matches(|c: char| c.is_ascii_digit() || "+-−.,eE".contains(c))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn amount(text: &str) -> Amount {
        Amount::Text(text.to_owned())
    }

    fn of(values: &str) -> Option<Variation> {
        Variation::read(Some("mass"), values)
    }

    #[test]
    fn variations_are_read_from_a_line() {
        let range = of("600..1800 rpm:13").unwrap();
        assert_eq!((range.from, range.to), (Some(amount("600 rpm")), Some(amount("1800 rpm"))));
        assert_eq!((range.points, range.scale), (Some(13), None));
        let range = of("1 kN/m..2 MN/m : 31 : log").unwrap();
        assert_eq!((range.from, range.to), (Some(amount("1 kN/m")), Some(amount("2 MN/m"))));
        assert_eq!(range.scale, Some(Spacing::Log));
        let values = of("40 kg; 45,5 kg; 46").unwrap().values.unwrap();
        assert_eq!(values, [amount("40 kg"), amount("45,5 kg"), Amount::Number(46.0)]);
        let normal = of("normal(2 %)").unwrap();
        assert_eq!((normal.mean, normal.deviation), (None, Some(amount("2 %"))));
        // Alone it is two percent, not two kilograms.
        assert_eq!(of("uniform(2)").unwrap().tolerance, Some(amount("2")));
        let triangular = of("triangular(38 kg; 40 kg; 45 kg)").unwrap();
        assert_eq!((triangular.from, triangular.mode), (Some(amount("38 kg")), Some(amount("40 kg"))));
        for wrong in ["", "40 kg;", "1..2", "1..2:few", "gamma(1; 2)", "1..2:3:cubic", "normal(1; 2; 3)"] {
            assert_eq!(of(wrong), None, "{wrong}");
        }
        assert_eq!(Variation::read(None, "table(a b.csv)").unwrap().table.as_deref(), Some("a b.csv"));
        assert_eq!(Variation::read(None, "40 kg"), None);
    }

    #[test]
    fn lines_are_read_as_what_was_written() {
        for line in [
            "600..1800 rpm:13",
            "-0.5..0.5 m/s:11:log",
            "1 kN/m..2 MN/m:31:linear",
            "0.1..0.2:5",
            "40 kg; 45.5 kg; 46",
            "normal(2 %)",
            "lognormal(40 kg; 1 kg)",
            "uniform(38 kg; 42 kg)",
            "triangular(38 kg; 45 kg)",
            "data(mass.csv; mass)",
        ] {
            let read = of(line).unwrap();
            assert_eq!(of(&read.line("kg")), Some(read.clone()), "{line}");
            assert_eq!(read.line("kg"), line);
        }
        // Numbers of a file are in the unit of the input; a width alone would be a share.
        let number = |number| Some(Amount::Number(number));
        let drawn = Variation { distribution: Some(DistributionKind::Uniform), ..Variation::default() };
        assert_eq!(Variation { tolerance: number(2.0), ..drawn }.line("kg"), "uniform(2 kg)");
        let mean = Some(amount("40 lb"));
        let normal = Variation { distribution: Some(DistributionKind::Normal), ..Variation::default() };
        assert_eq!(Variation { mean, deviation: number(2.0), ..normal }.line("kg"), "normal(40 lb; 2 lb)");
        let to = Some(amount("1800 rpm"));
        let range = Variation { from: number(60.0), to, points: Some(3), ..Variation::default() };
        assert_eq!(range.line("rad/s"), "60 rad/s..1800 rpm:3");
    }

    #[test]
    fn limits_and_correlations_are_read_from_a_line() {
        assert_eq!(Limit::read("amplitude > 0.2 mm").unwrap().above, Some(amount("0.2 mm")));
        assert_eq!(Limit::read("margin<0").unwrap().below, Some(Amount::Number(0.0)));
        let both = Limit::read("amplitude > 9 mm; < 2 mm").unwrap();
        assert_eq!((both.above.clone(), both.below.clone()), (Some(amount("9 mm")), Some(amount("2 mm"))));
        assert_eq!(Limit::read(&both.line()), Some(both));
        for wrong in ["amplitude", "> 2", "a > 1; > 2", "a > ", "a > 1; b"] {
            assert_eq!(Limit::read(wrong), None, "{wrong}");
        }
        let correlation = Correlation::read("mass; support.length: −0,5").unwrap();
        assert_eq!(correlation.inputs, ["mass", "support.length"]);
        assert_eq!(correlation.coefficient, -0.5);
        assert_eq!(Correlation::read(&correlation.line()), Some(correlation));
        for wrong in ["mass: 0.5", "mass; : 0.5", "mass; speed", "mass; speed: much"] {
            assert_eq!(Correlation::read(wrong), None, "{wrong}");
        }
    }
}
