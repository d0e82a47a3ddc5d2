//! Figures of a study: tornado, scatter, maps.

use dalembert_core::{
    Answer, Axis, Locale, Plot, Series, Text,
    study::{AnswerStatistics, LevelMean, Study, Summary},
};
use dalembert_units as units;

use crate::figure::{
    self,
    map::{MapAxis, map},
    picture::Picture,
    tornado::TornadoBar,
};

/// Digits of a level on the axis of a map.
const LEVEL_DIGITS: u8 = 3;

/// The range of the mean of an answer over each of these inputs, about its mean.
pub(crate) fn tornado(
    study: &Study<'_>,
    answer: &Answer,
    of: &AnswerStatistics,
    ranked: &[(usize, [f64; 2])],
    locale: &Locale,
) -> Option<Picture> {
    let bar = |(input, ends): &(usize, [f64; 2])| TornadoBar {
        name: study.design.inputs[*input].label.render(locale),
        ends: ends.map(|end| answer.unit.si(end)),
    };
    let bars: Vec<TornadoBar> = ranked.iter().map(bar).collect();
    let title =
        Text::new("Mean of {answer} over the range of each input").with_text("answer", answer.title());
    let axis = axis(answer);
    figure::tornado::tornado(title.render(locale), &axis, answer.unit.si(of.mean), &bars, locale)
}

/// An answer over an input, at the points of the sample.
pub(crate) fn scatter(
    study: &Study<'_>,
    summary: &Summary,
    place: usize,
    input: usize,
    locale: &Locale,
) -> Option<Picture> {
    let (answer, over) = (&study.answers[place], &study.design.inputs[input]);
    let column = study.design.inputs.len() + place;
    let points = summary.sample.iter().filter(|row| row[column].is_finite());
    let points = points.map(|row| (over.unit.si(row[input]), answer.unit.si(row[column]))).collect();
    let series = Series { joined: false, ..Series::line("", points) };
    let title = Text::new("{answer} over {input}")
        .with_text("answer", answer.title())
        .with_text("input", over.label.clone());
    let x = Axis::in_unit(over.label.clone(), &over.unit);
    figure::scatter(&Plot::new(title, x, axis(answer), vec![series]), locale)
}

/// An answer over pairs of inputs: its mean at their levels.
pub(crate) fn maps(study: &Study<'_>, summary: &Summary, place: usize, locale: &Locale) -> Vec<Picture> {
    let answer = &study.answers[place];
    let style = units::Style { digits: LEVEL_DIGITS, ..locale.style };
    let of = |(pair, means): (&[usize; 2], &Vec<LevelMean>)| {
        let axes = pair.map(|input| {
            let (over, levels) = (&study.design.inputs[input], &summary.levels[input]);
            let unit = over.unit.shown(locale.style.ascii);
            let name = over.label.render(locale);
            MapAxis {
                name: if unit.is_empty() { name } else { format!("{name} [{unit}]") },
                levels: levels.iter().map(|level| units::write_number(*level, style)).collect(),
            }
        });
        let title = Text::new("{answer} over {input} and {other}")
            .with_text("answer", answer.title())
            .with_text("input", study.design.inputs[pair[0]].label.clone())
            .with_text("other", study.design.inputs[pair[1]].label.clone());
        let value = |mean: &LevelMean| (mean.count > 0).then(|| answer.unit.si(mean.mean));
        let values: Vec<Option<f64>> = means.iter().map(value).collect();
        map(title.render(locale), axes.each_ref(), &axis(answer), &values, locale)
    };
    let means = summary.answers[place].maps.iter();
    summary.maps.iter().zip(means).filter_map(of).collect()
}

fn axis(answer: &Answer) -> Axis {
    Axis::in_unit(answer.title(), &answer.unit)
}
