//! Harmonic excitation.

pub mod base_excitation;
pub mod equivalent_damping;
pub mod forced_coulomb;
pub mod frequency_response_identification;
pub mod harmonic_analysis;
pub mod harmonic_force;
pub mod harmonic_sum;
pub mod loss_of_contact;
pub mod periodic_excitation;
pub mod rotating_unbalance;
