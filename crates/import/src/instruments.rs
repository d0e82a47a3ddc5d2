//! Texts of instruments whose rows have no times, or whose columns a key above them describes.

use dalembert_core::Text;

use crate::units_above::bracketed;

/// The text with a time in each row and its units in the heading, where an instrument is recognised; line by line the same.
///
/// Error: a file of the instrument that has not what makes the times.
pub(crate) fn with_times(text: &str) -> Result<Option<String>, Text> {
    let first = text.lines().map(str::trim).find(|line| !line.is_empty() && *line != "#").unwrap_or_default();
    if first.starts_with("LabVIEW Measurement") {
        return labview(text).map(Some);
    }
    let head: Vec<&str> = first.split(',').map(str::trim).collect();
    let is_rigol = head.first() == Some(&"X") && head.contains(&"Start") && head.contains(&"Increment");
    Ok(is_rigol.then(|| rigol(text, &head)).flatten())
}

/// Rigol's oscilloscopes: `X,CH1,Start,Increment`, below it units, start and increment, then a number of each sample.
fn rigol(text: &str, head: &[&str]) -> Option<String> {
    let at = |name: &str| head.iter().position(|cell| *cell == name);
    let (start_at, increment_at) = (at("Start")?, at("Increment")?);
    let channels = 1..start_at.min(increment_at);
    let mut lines = text.lines();
    let mut table = String::new();
    let mut scale = None;
    for line in &mut lines {
        let cells: Vec<&str> = line.split(',').map(str::trim).collect();
        if cells.first() == Some(&"X") {
            table += &format!("t,{}\n", head[channels.clone()].join(","));
            continue;
        }
        if cells.len() <= start_at.max(increment_at) {
            table += "#\n";
            continue;
        }
        scale = cells[start_at].parse::<f64>().ok().zip(cells[increment_at].parse::<f64>().ok());
        let units: Vec<String> = cells[channels.clone()].iter().map(|unit| bracketed(unit)).collect();
        table += &format!("[s],{}\n", units.join(","));
        break;
    }
    let (start, increment) = scale?;
    for line in lines {
        match line.split_once(',') {
            Some((number, rest)) => {
                let number: f64 = number.trim().parse().ok()?;
                table += &format!(
                    "{},{}\n",
                    written(start + number * increment),
                    rest.trim_end_matches([',', ' '])
                );
            }
            None if line.trim().is_empty() => table.push('\n'),
            None => return None,
        }
    }
    Some(table)
}

/// LabVIEW's measurement files, `.lvm`: two headers of keys, each up to `***End_of_Header***`, then names and rows.
///
/// `X_Columns` says whether the times stand in a column (`One`, `Multi`) or follow from `X0` and `Delta_X` (`No`).
fn labview(text: &str) -> Result<String, Text> {
    const END: &str = "***End_of_Header***";
    let wrong = |why: &'static str| Err(Text::from(why));
    let lines: Vec<&str> = text.lines().collect();
    let ends: Vec<usize> = (0..lines.len()).filter(|at| lines[*at].trim().starts_with(END)).collect();
    let [first, second] = ends.as_slice() else {
        return wrong(
            "this LabVIEW file has not one set of rows: save one set of measurements a file, or choose lines by `#skip=`",
        );
    };
    let separator = if lines[..*first].iter().any(|line| line.contains('\t')) { '\t' } else { ',' };
    let key = |range: std::ops::Range<usize>, name: &str| -> Vec<&str> {
        let line = lines[range].iter().find(|line| line.split(separator).next().map(str::trim) == Some(name));
        let cells = line.map(|line| line.split(separator).skip(1).map(str::trim).collect::<Vec<_>>());
        cells.unwrap_or_default().into_iter().filter(|cell| !cell.is_empty()).collect()
    };
    let of_segment = |name: &str| key(*first + 1..*second, name);
    let is_without_times = key(0..*first, "X_Columns").first() == Some(&"No");
    let is_multiple = key(0..*first, "X_Columns").first() == Some(&"Multi");
    let count = of_segment("Channels").first().and_then(|count| count.parse::<usize>().ok());
    let Some(count) = count.filter(|count| *count > 0) else {
        return wrong("this LabVIEW file does not give its channels: leave its header out by `#skip=`");
    };
    let number = |text: &str| text.replace(',', ".").parse::<f64>().ok();
    let first_of = |name: &str| of_segment(name).first().and_then(|text| number(text));
    let (start, step) = (first_of("X0").unwrap_or(0.0), first_of("Delta_X"));
    let x_unit = match of_segment("X_Dimension").first() {
        Some(&"Time") | None => "[s]".to_owned(),
        Some(&"Frequency") => "[Hz]".to_owned(),
        Some(_) => of_segment("X_Unit_Label").first().map_or(String::new(), |unit| bracketed(unit)),
    };
    let y_units = of_segment("Y_Unit_Label");
    let heads = |names: &[&str]| -> String {
        let mut cells = Vec::new();
        for channel in 0..count {
            if channel == 0 || is_multiple {
                cells.push(format!("X {x_unit}"));
            }
            let unit = y_units.get(channel).map_or(String::new(), |unit| bracketed(unit));
            cells.push(format!("{} {unit}", names.get(channel).unwrap_or(&"Y")));
        }
        cells.join("\t")
    };
    let width = if is_multiple { 2 * count } else { count + 1 };
    let mut table = String::new();
    let mut rows = 0.0;
    for (at, line) in lines.iter().enumerate() {
        let cells: Vec<&str> = line.split(separator).map(str::trim).collect();
        if at <= *second || line.trim().is_empty() {
            table += if line.trim().is_empty() { "" } else { "#" };
        } else if cells[0] == "X_Value" {
            let names: Vec<&str> = cells[1..].iter().copied().filter(|name| *name != "X_Value").collect();
            table += &heads(&names);
        } else if is_without_times {
            let Some(step) = step else {
                return wrong("this LabVIEW file has neither times nor Delta_X: save it with one X column");
            };
            let values = if cells[0].is_empty() { &cells[1..] } else { &cells[..] };
            let values: Vec<&str> = values.iter().copied().take(count).collect();
            table += &format!("{}\t{}", written(start + rows * step), values.join("\t"));
            rows += 1.0;
        } else {
            table += &cells.iter().copied().take(width).collect::<Vec<_>>().join("\t");
        }
        table.push('\n');
    }
    Ok(table)
}

/// A number that reads back as itself.
pub(crate) fn written(x: f64) -> String {
    if x == 0.0 || (1e-3..1e7).contains(&x.abs()) { format!("{x}") } else { format!("{x:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_number_of_a_sample_becomes_its_time() {
        let text = "X,CH1,Start,Increment,\nSequence,Volt,-1.0e-02,5.0e-03\n0,1.5,\n1,1.6,\n2,1.7,\n";
        let wanted = "t,CH1\n[s],[V]\n-0.01,1.5\n-0.005,1.6\n0,1.7\n";
        assert_eq!(with_times(text), Ok(Some(wanted.to_owned())));
        assert_eq!(with_times("X,CH1\n0,1\n"), Ok(None));
    }

    const LABVIEW: &str = "LabVIEW Measurement\t\nSeparator\tTab\nX_Columns\tNo\n***End_of_Header***\t\n\t\n\
                           Channels\t1\nY_Unit_Label\tmm\nX_Dimension\tTime\nX0\t0\nDelta_X\t0.002\n\
                           ***End_of_Header***\t\nX_Value\tDisplacement\tComment\n\t1.5\n\t1.6\n";

    #[test]
    fn times_that_labview_leaves_out_follow_from_its_step() {
        let wanted = "X [s]\tDisplacement [mm]\n0\t1.5\n0.002\t1.6\n";
        assert!(with_times(LABVIEW).is_ok_and(|text| text.is_some_and(|text| text.ends_with(wanted))));
        let one = LABVIEW.replace("Columns\tNo", "Columns\tOne").replace("\t1.", "0\t1.");
        assert!(
            with_times(&one).is_ok_and(|text| text.is_some_and(|text| text.ends_with("\n0\t1.5\n0\t1.6\n")))
        );
        assert!(with_times(&(LABVIEW.to_owned() + LABVIEW)).is_err());
        assert!(with_times(&LABVIEW.replace("Delta_X", "Delta")).is_err());
    }
}
