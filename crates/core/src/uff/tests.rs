use super::*;
use itertools::Itertools as _;

/// The records of a dataset up to its values; `binary` is what stands behind the 58.
fn head(binary: &str, form: [i64; 3], start: f64, step: f64, ordinate: (i64, &str)) -> String {
    let id = "FRF of the beam";
    let dof =
        format!("{:5}{:10}{:5}{:10} {:10}{:10}{:4} {:10}{:10}{:4}", 4, 0, 0, 0, "NONE", 5, 3, "NONE", 1, -3);
    let [kind, count, spacing] = form;
    let form = format!("{kind:10}{count:10}{spacing:10}{start:13.5e}{step:13.5e}{:13.5e}", 0.0);
    let axis = |kind: i64, unit: &str| format!("{kind:10}{:5}{:5}{:5} {:<20} {unit:<20}", 0, 0, 0, "NONE");
    let (ordinate, unit) = ordinate;
    format!(
        "    -1\n    58{binary}\n{id}\nNONE\nNONE\nNONE\nNONE\n{dof}\n{form}\n{}\n{}\n{}\n{}\n",
        axis(18, "Hz"),
        axis(ordinate, unit),
        axis(13, "N"),
        axis(0, "NONE"),
    )
}

const POINTS: [[f64; 3]; 3] =
    [[5.0, 1.0237e-4, -8.5187e-6], [5.5, 4.5066e-4, -7.7914e-4], [6.0, -9.4101e-5, -1.0585e-5]];

fn only(bytes: &[u8]) -> UffFunction {
    let (mut found, skipped) = functions(bytes);
    assert!(skipped.is_empty(), "{skipped:?}");
    assert_eq!(found.len(), 1);
    found.remove(0)
}

fn near(function: &UffFunction, relative: f64) {
    assert_eq!(function.points.len(), POINTS.len());
    for (ours, wanted) in function.points.iter().flatten().zip_eq(POINTS.iter().flatten()) {
        assert!((ours - wanted).abs() <= relative * wanted.abs(), "{ours} is not {wanted}");
    }
}

/// A number in so many columns, as Fortran writes it.
fn fortran(x: f64, width: usize, digits: usize) -> String {
    let text = format!("{x:.digits$e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{:>width$}", format!("{mantissa}E{sign}{:02}", exponent.abs()))
}

#[test]
fn text_with_even_and_uneven_abscissas() {
    let mut even = head("", [5, 3, 1], 5.0, 0.5, (8, "m"));
    let flat: Vec<f64> = POINTS.iter().flat_map(|[_, re, im]| [*re, *im]).collect();
    even += &flat.iter().map(|x| fortran(*x, 13, 5)).collect::<String>();
    even += "\n    -1\n";
    let function = only(even.as_bytes());
    near(&function, 1e-5);
    assert_eq!((function.response, function.reference, function.kind), ((5, 3), (1, -3), 4));
    assert_eq!((function.name.as_str(), function.line), ("FRF of the beam", 1));

    let mut uneven = head("", [6, 3, 0], 0.0, 0.0, (8, "m"));
    for [x, re, im] in POINTS {
        uneven += &format!("{}{}{}\r\n", fortran(x, 13, 5), fortran(re, 20, 11), fortran(im, 20, 11));
    }
    uneven += "    -1\r\n";
    near(&only(uneven.as_bytes()), 1e-12);
    // Exponents as the older Fortran writes them.
    near(&only(uneven.replace('E', "D").replace("FRF", "frf").replace("NOND", "NONE").as_bytes()), 1e-12);
}

#[test]
fn numbers_that_touch_are_parted_by_their_columns() {
    let mut file = head("", [5, 2, 1], 5.0, 0.5, (8, "m"));
    file += "-1.23456E-105-2.34567E-105-3.45678E-105-4.56789E-105\n    -1\n";
    let function = only(file.as_bytes());
    assert_eq!(function.points, [[5.0, -1.23456e-105, -2.34567e-105], [5.5, -3.45678e-105, -4.56789e-105]]);
}

#[test]
fn bytes_in_both_orders_and_both_sizes() {
    for (order, little) in [(1, true), (2, false)] {
        let put = |x: f64, double: bool, out: &mut Vec<u8>| match (double, little) {
            (true, true) => out.extend(x.to_le_bytes()),
            (true, false) => out.extend(x.to_be_bytes()),
            (false, true) => out.extend((x as f32).to_le_bytes()),
            (false, false) => out.extend((x as f32).to_be_bytes()),
        };
        // (type, abscissas in the file, those double)
        for (kind, spacing, double_abscissa) in
            [(5, 1, false), (6, 1, false), (5, 0, false), (6, 0, true), (6, 0, false)]
        {
            let double = kind == 6;
            let mut data = Vec::new();
            for [x, re, im] in POINTS {
                if spacing == 0 {
                    put(x, double_abscissa, &mut data);
                }
                put(re, double, &mut data);
                put(im, double, &mut data);
            }
            // Some programs announce another number of bytes than they write.
            for announced in [data.len(), 24] {
                let header =
                    format!("b{order:6}{:6}{:12}{announced:12}{:6}{:6}{:12}{:12}", 2, 11, 0, 0, 0, 0);
                for end in ["    -1\n", "\n    -1\n"] {
                    let mut file = head(&header, [kind, 3, spacing], 5.0, 0.5, (8, "m")).into_bytes();
                    file.extend(&data);
                    file.extend(end.as_bytes());
                    let second = file.clone();
                    file.extend(second);
                    let (found, skipped) = functions(&file);
                    assert!(skipped.is_empty() && found.len() == 2, "{skipped:?}");
                    for function in &found {
                        near(function, if double { 1e-15 } else { 1e-7 });
                    }
                }
            }
        }
    }
}

#[test]
fn what_is_left_out_is_named_with_its_line() {
    let mut file = "    -1\n   151\nmodel\n    -1\nstray\n".to_owned();
    file += &head("", [5, 3, 1], 5.0, 0.5, (8, "m"));
    file += " 1.0E-4 2.0E-4 broken\n    -1\n";
    file += &head("", [9, 3, 1], 5.0, 0.5, (8, "m"));
    file += "    -1\n";
    file += &head("", [5, 3, 1], 5.0, 0.5, (8, "m"));
    file += " 1.0E-4 2.0E-4\n    -1\n";
    let (found, skipped) = functions(file.as_bytes());
    assert!(found.is_empty());
    let reported: Vec<(usize, String)> = skipped.iter().map(|it| (it.line, it.why.english())).collect();
    let wanted = [
        (1, "dataset 151 is not a function"),
        (5, "is between datasets"),
        (19, "`broken` is not a number"),
        (29, "values of type 9 are not read; types 2, 4, 5 and 6 are"),
        (35, "the function has 2 numbers; its header announces 6"),
    ];
    assert_eq!(reported.len(), wanted.len(), "{reported:?}");
    for ((line, why), (wanted_line, wanted_why)) in reported.iter().zip_eq(wanted) {
        assert_eq!((*line, why.as_str()), (wanted_line, wanted_why), "{reported:?}");
    }
}

#[test]
fn any_bytes_are_read_without_a_panic() {
    let mut file = head("b     1     2          11          48", [6, 3, 0], 5.0, 0.5, (8, "m")).into_bytes();
    file.extend([0x2d; 72]);
    file.extend(b"    -1\n");
    for cut in 0..file.len() {
        let _ = functions(&file[..cut]);
        let mut changed = file.clone();
        changed[cut] = changed[cut].wrapping_add(97);
        let _ = functions(&changed);
    }
    assert!(!is_universal(b"5; 1e-4; 2e-4"));
    assert!(!is_universal(b"-1\n-2\n") && !is_universal(b"-1; 58"));
    assert!(is_universal(b"\n    -1\n   151\n"));
}
