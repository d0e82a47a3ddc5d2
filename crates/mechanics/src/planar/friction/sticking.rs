//! Joints with friction at rest: those that stick, and those that begin to slide.

use itertools::Itertools;
use nalgebra::DMatrix;

use super::{Contact, FrictionResponse};
use crate::planar::{
    PlanarError,
    tolerances::{
        DEAD_CENTRE_SLIDING, GAUSS_SEIDEL_REST, GAUSS_SEIDEL_SWEEPS, MAX_STARTING_MOTIONS,
        PROPORTIONAL_SLIDING,
    },
    vectors::{dot, largest},
};
use dalembert_numerics::linalg::Elimination;

impl FrictionResponse<'_> {
    /// Finds which joints stick and which begin to slide, from those that slide already, whose contacts are given as
    /// [`Contact::Sliding`]; and the efforts of the frictions, N. A joint that slides slower than `rounding` times
    /// `max_velocity` may be put to rest again; an acceleration below `rounding` times the largest is none, and one
    /// below `opening` times the largest begins no motion.
    ///
    /// # Errors
    /// `Jammed`, `Sticks`.
    pub(in super::super) fn settle(
        &self,
        contacts: &mut Vec<Contact>,
        max_velocity: f64,
        [rounding, opening]: [f64; 2],
    ) -> Result<Vec<f64>, PlanarError> {
        let rest = rounding * max_velocity;
        for sweeps in GAUSS_SEIDEL_SWEEPS {
            if sweeps > 0 {
                self.guess(contacts, rest, sweeps);
            }
            for _ in 0..=contacts.len() + 1 {
                self.hold(contacts)?;
                let Some(efforts) = self.bearing(contacts) else { break };
                let largest = self.largest_acceleration(&efforts);
                if self.corrected(contacts, &efforts, rest, rounding * largest) {
                    continue;
                }
                match self.opening(contacts)? {
                    Some((surplus, begun)) if surplus > opening * largest => *contacts = begun,
                    _ => return Ok(efforts),
                }
            }
        }
        Err(self.jammed())
    }

    /// Puts to rest a joint without velocity that would slide against its sense, and lets slide one that friction does
    /// not hold; true if there was any of either. A velocity up to `rest`, m/s, and an acceleration up to `none`, m/s²,
    /// are none.
    fn corrected(&self, contacts: &mut [Contact], efforts: &[f64], rest: f64, none: f64) -> bool {
        let mut corrected = false;
        for (row, contact) in contacts.iter_mut().enumerate() {
            let acceleration = self.sliding_acceleration(row, efforts);
            let right = match *contact {
                Contact::Sliding { sense, .. }
                    if self.rates[row].abs() <= rest && sense * acceleration < -none =>
                {
                    Contact::Indeterminate
                }
                Contact::Sticking | Contact::Indeterminate if acceleration.abs() > none => {
                    Contact::Sliding { sense: acceleration.signum(), side: 1.0 }
                }
                _ => continue,
            };
            (*contact, corrected) = (right, true);
        }
        corrected
    }

    /// Guesses how the joints without a velocity move: of the friction of each in turn as much as stops its sliding, up
    /// to μ N (the projected method of Gauss and Seidel).
    fn guess(&self, contacts: &mut [Contact], rest: f64, sweeps: usize) {
        let mut efforts = vec![0.0; contacts.len()];
        for _ in 0..sweeps {
            for (row, contact) in contacts.iter().enumerate() {
                let [x, y] = self.force(row, &efforts);
                let most = self.limits[row] * x.hypot(y);
                if !most.is_finite() {
                    return;
                }
                efforts[row] = match contact {
                    Contact::Sliding { sense, .. } if self.rates[row].abs() > rest => -sense * most,
                    _ => {
                        let stops = efforts[row]
                            - self.sliding_acceleration(row, &efforts) / self.inverse_mass[(row, row)];
                        if stops.is_nan() { 0.0 } else { stops.clamp(-most, most) }
                    }
                };
            }
        }
        let none = GAUSS_SEIDEL_REST * self.largest_acceleration(&efforts);
        for (row, contact) in contacts.iter_mut().enumerate() {
            if self.rates[row].abs() <= rest {
                let acceleration = self.sliding_acceleration(row, &efforts);
                *contact = if acceleration.abs() <= none {
                    Contact::Indeterminate
                } else {
                    Contact::Sliding { sense: acceleration.signum(), side: 1.0 }
                };
            }
        }
    }

    /// Of all motions that the joints at rest could begin, that which goes on most: the acceleration, m/s², with which
    /// it would, negative if friction stops it, and the contacts then. None if no joint is held.
    ///
    /// # Errors
    /// `Sticks` if there are too many to be tried.
    pub(in super::super) fn opening(
        &self,
        contacts: &[Contact],
    ) -> Result<Option<(f64, Vec<Contact>)>, PlanarError> {
        let held: Vec<usize> =
            (0..contacts.len()).filter(|&row| contacts[row] == Contact::Sticking).collect();
        let groups = self.groups(contacts);
        let mut best: Option<(f64, Vec<Contact>)> = None;
        let Some(others) = held.len().checked_sub(1) else { return Ok(None) };
        for (tried, kept) in groups.into_iter().combinations(others).enumerate() {
            if tried == MAX_STARTING_MOTIONS {
                return Err(PlanarError::Sticks { load: self.frictions[held[0]].load });
            }
            let rows = DMatrix::from_fn(kept.len(), self.sliding_in_basis[held[0]].len(), |row, column| {
                self.sliding_in_basis[kept[row]][column]
            });
            if !kept.is_empty() && Elimination::new(&rows)?.rank() < kept.len() {
                continue;
            }
            if let Some(begun) = self.beginning(contacts, &kept)
                && best.as_ref().is_none_or(|(most, _)| begun.0 > *most)
            {
                best = Some(begun);
            }
        }
        Ok(best)
    }

    /// The motion that begins when of the joints at rest these alone stick: its acceleration, m/s², and contacts.
    fn beginning(&self, contacts: &[Contact], kept: &[usize]) -> Option<(f64, Vec<Contact>)> {
        let mut trial = contacts.to_vec();
        for (row, contact) in trial.iter_mut().enumerate() {
            if !matches!(contact, Contact::Sliding { .. }) {
                *contact = if kept.contains(&row) { Contact::Sticking } else { Contact::Indeterminate };
            }
        }
        // How the released joints slide with one another: by a unit of the friction of one of them.
        let released: Vec<usize> =
            (0..trial.len()).filter(|&row| trial[row] == Contact::Indeterminate).collect();
        let sliding = self.released(kept, &released)?;
        let fastest = largest(&sliding);
        let lead = (0..sliding.len()).find(|&at| sliding[at].abs() == fastest)?;
        let frictionless = self.bearing(&mut trial)?;
        let sense = if self.sliding_acceleration(released[lead], &frictionless) * sliding[lead] < 0.0 {
            -1.0
        } else {
            1.0
        };
        for (&row, rate) in released.iter().zip(&sliding) {
            if rate.abs() > PROPORTIONAL_SLIDING * fastest {
                trial[row] = Contact::Sliding { sense: sense * rate.signum(), side: 1.0 };
            }
        }
        let efforts = self.bearing(&mut trial)?;
        let surplus = sense * sliding[lead].signum() * self.sliding_acceleration(released[lead], &efforts);
        Some((surplus, trial))
    }

    /// The accelerations of released joints, relative to one another, in the one motion that is left while some are
    /// kept.
    fn released(&self, kept: &[usize], released: &[usize]) -> Option<Vec<f64>> {
        let among = DMatrix::from_fn(kept.len(), kept.len(), |row, column| {
            self.inverse_mass[(kept[row], kept[column])]
        });
        let elimination = Elimination::new(&among).ok()?;
        // Of the joints, that which the others hold least.
        let of_unit = |unit: usize| -> Option<Vec<f64>> {
            let rhs: Vec<f64> = kept.iter().map(|&row| -self.inverse_mass[(row, unit)]).collect();
            let holding = elimination.solve(&rhs).ok()?;
            let of_row = |&row: &usize| {
                let held: f64 =
                    kept.iter().zip(&holding).map(|(&kept, x)| self.inverse_mass[(row, kept)] * x).sum();
                self.inverse_mass[(row, unit)] + held
            };
            Some(released.iter().map(of_row).collect())
        };
        let sliding = released.iter().map(|&unit| of_unit(unit)).collect::<Option<Vec<_>>>()?;
        sliding.into_iter().max_by(|a, b| largest(a).total_cmp(&largest(b)))
    }

    /// Lets an independent set of the joints at rest stick; the friction of the others is indeterminate.
    fn hold(&self, contacts: &mut [Contact]) -> Result<(), PlanarError> {
        let resting = self.resting(contacts);
        for contact in contacts.iter_mut().filter(|contact| **contact == Contact::Sticking) {
            *contact = Contact::Indeterminate;
        }
        let Some(&first) = resting.first() else { return Ok(()) };
        let rows = DMatrix::from_fn(resting.len(), self.sliding_in_basis[first].len(), |row, column| {
            self.sliding_in_basis[resting[row]][column]
        });
        for &row in Elimination::new(&rows)?.independent_rows() {
            contacts[resting[row]] = Contact::Sticking;
        }
        Ok(())
    }

    /// The joints at rest that friction could hold.
    fn resting(&self, contacts: &[Contact]) -> Vec<usize> {
        let rests = |row: &usize| {
            !matches!(contacts[*row], Contact::Sliding { .. })
                && largest(&self.sliding_in_basis[*row]) > DEAD_CENTRE_SLIDING
        };
        (0..contacts.len()).filter(rests).collect()
    }

    /// One of the joints at rest of each group that always slides together.
    fn groups(&self, contacts: &[Contact]) -> Vec<usize> {
        let mut groups: Vec<usize> = Vec::new();
        for row in self.resting(contacts) {
            let together = |&other: &usize| {
                let (a, b) = (&self.sliding_in_basis[row], &self.sliding_in_basis[other]);
                let part = dot(a, b) / dot(b, b);
                a.iter()
                    .zip(b)
                    .all(|(a_k, b_k)| (a_k - part * b_k).abs() <= PROPORTIONAL_SLIDING * largest(a))
            };
            if !groups.iter().any(together) {
                groups.push(row);
            }
        }
        groups
    }

    /// The change of the independent velocities, m/s, that brings all joints slower than `rest`, m/s, to rest.
    pub(in super::super) fn stopped(&self, contacts: &[Contact], rest: f64) -> Result<Vec<f64>, PlanarError> {
        let mut change = vec![0.0; self.base.independent.len()];
        let slow = |row: &usize| {
            self.rates[*row].abs() <= rest && largest(&self.sliding_in_basis[*row]) > DEAD_CENTRE_SLIDING
        };
        let slow: Vec<usize> = (0..contacts.len()).filter(slow).collect();
        let among = DMatrix::from_fn(slow.len(), slow.len(), |row, column| {
            self.inverse_mass[(slow[row], slow[column])]
        });
        let rates: Vec<f64> = slow.iter().map(|&row| -self.rates[row]).collect();
        if !slow.is_empty() {
            for (&row, impulse) in slow.iter().zip(Elimination::new(&among)?.solve(&rates)?) {
                for (change, unit) in change.iter_mut().zip(&self.units[row].independent) {
                    *change += impulse * unit;
                }
            }
        }
        Ok(change)
    }
}
