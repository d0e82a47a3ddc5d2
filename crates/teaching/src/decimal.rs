//! Numbers of tables and platforms.

/// A number with six significant digits.
pub(crate) fn rounded(number: f64) -> f64 {
    format!("{number:.5e}").parse().unwrap_or(f64::NAN)
}

/// A number with a decimal point and at most six significant digits, without a power of ten.
pub(crate) fn number(number: f64) -> String {
    rounded(number).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_without_a_power_of_ten() {
        assert_eq!(number(19.456_371_2), "19.4564");
        assert_eq!(number(-1.3e-7), "-0.00000013");
        assert_eq!(number(451_389.2), "451389");
        assert_eq!(number(0.0), "0");
    }
}
