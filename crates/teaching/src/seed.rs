//! Seeds, and what is drawn from them.

use dalembert_numerics::random::uniform;

/// Seed of a student: the 64-bit FNV-1a hash of the UTF-8 bytes of the id, without white space around it. It is the same
/// in every version of the program.
pub fn seed_of(student: &str) -> u64 {
    student
        .trim()
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// Place of one of `count` equally probable values that belongs to this seed, try and input.
pub(crate) fn drawn(seed: u64, trial: u64, input: usize, count: usize) -> usize {
    ((uniform(seed, trial, input as u64) * count as f64) as usize).min(count.saturating_sub(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_have_the_published_hashes() {
        // The test vectors of the authors of FNV.
        assert_eq!(seed_of(""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(seed_of("a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(seed_of("foobar"), 0x8594_4171_f739_67e8);
        assert_eq!(seed_of(" 2023001 \n"), seed_of("2023001"));
        assert_ne!(seed_of("2023001"), seed_of("2023002"));
    }

    #[test]
    fn values_are_drawn_alike() {
        let mut counts = [0; 7];
        for trial in 0..7000 {
            counts[drawn(5, trial, 0, 7)] += 1;
        }
        assert!(counts.iter().all(|count| (850..1150).contains(count)), "{counts:?}");
    }
}
