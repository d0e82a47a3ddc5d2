//! Campbell diagram: natural frequencies against speed, modes paired by the modal assurance criterion.

use super::{
    RotorError,
    modes::{ReducedRotor, Spectrum, WhirlMode},
};

/// Modes over speeds.
#[derive(Debug, Clone, PartialEq)]
pub struct Campbell {
    /// The speeds, rad/s, ascending.
    pub speeds: Vec<f64>,
    /// The modes, each at every speed where it oscillates and is among those computed.
    pub branches: Vec<Vec<Option<WhirlMode>>>,
    /// All that was found at every speed.
    pub spectra: Vec<Spectrum>,
}

/// Follows the modes over ascending speeds, rad/s.
///
/// A mode is known again by its shape (modal assurance criterion), from the highest speed down, since at rest the
/// shapes of a symmetric rotor are arbitrary. Where two shapes are too unlike, speeds between are examined.
///
/// # Errors
/// `Linalg`.
pub fn campbell(reduced: &ReducedRotor<'_>, speeds: &[f64]) -> Result<Campbell, RotorError> {
    let mut branches: Vec<Vec<Option<WhirlMode>>> = Vec::new();
    let mut spectra = Vec::with_capacity(speeds.len());
    // The last sight of every branch.
    let mut seen: Vec<Option<WhirlMode>> = Vec::new();
    for at in (0..speeds.len()).rev() {
        let spectrum = reduced.modes(speeds[at])?;
        let mut modes: Vec<Option<WhirlMode>> = spectrum.modes.iter().cloned().map(Some).collect();
        spectra.push(spectrum);
        if let Some(&above) = speeds.get(at + 1) {
            let places = follow(reduced, &seen, (above, speeds[at]), &modes, 5)?;
            for (branch, place) in places.into_iter().enumerate() {
                seen[branch] = place.and_then(|place| modes[place].take());
                branches[branch][at].clone_from(&seen[branch]);
            }
        }
        for mode in modes.into_iter().flatten() {
            let mut branch = vec![None; speeds.len()];
            branch[at] = Some(mode.clone());
            branches.push(branch);
            seen.push(Some(mode));
        }
    }
    let first = |branch: &Vec<Option<WhirlMode>>| {
        branch.iter().flatten().next().map_or(f64::INFINITY, WhirlMode::frequency)
    };
    branches.sort_by(|a, b| first(a).total_cmp(&first(b)));
    spectra.reverse();
    Ok(Campbell { speeds: speeds.to_vec(), branches, spectra })
}

/// For each branch, the place of its mode among `modes`, one step of speed further on.
fn follow(
    reduced: &ReducedRotor<'_>,
    seen: &[Option<WhirlMode>],
    (from, to): (f64, f64),
    modes: &[Option<WhirlMode>],
    depth: u8,
) -> Result<Vec<Option<usize>>, RotorError> {
    let mut pairs = Vec::new();
    for (branch, before) in seen.iter().enumerate() {
        let Some(before) = before else { continue };
        for (place, after) in modes.iter().enumerate() {
            let Some(after) = after else { continue };
            pairs.push((before.assurance(after), branch, place));
        }
    }
    pairs.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut places = vec![None; seen.len()];
    let mut taken = vec![false; modes.len()];
    let mut worst = 1.0f64;
    for (assurance, branch, place) in pairs {
        if places[branch].is_none() && !taken[place] && assurance > 0.1 {
            places[branch] = Some(place);
            taken[place] = true;
            worst = worst.min(assurance);
        }
    }
    // At rest two planes of equal frequency have no shapes of their own: no speed between would help.
    if worst < 0.7 && depth > 0 && to > 0.0 {
        let middle = 0.5 * (from + to);
        let between: Vec<Option<WhirlMode>> = reduced.modes(middle)?.modes.into_iter().map(Some).collect();
        let first = follow(reduced, seen, (from, middle), &between, depth - 1)?;
        let mid: Vec<Option<WhirlMode>> =
            first.iter().map(|place| place.and_then(|place| between[place].clone())).collect();
        return follow(reduced, &mid, (middle, to), modes, depth - 1);
    }
    Ok(places)
}
