//! Analyses of vibration: one degree of freedom, rotating unbalance, whirl, identification.

pub mod bar_on_two_springs;
pub mod base_excitation;
pub mod beam_and_springs;
pub mod coulomb_damping;
pub mod coupled_pendulums;
pub mod decay;
pub mod decay_identification;
pub mod duffing_oscillator;
pub mod equivalent_damping;
pub mod equivalent_stiffness;
pub mod forced_coulomb;
pub mod free_vibration;
pub mod frequency_response_identification;
pub mod frequency_response_matrix;
pub mod friction_damper;
pub mod gun_recoil;
pub mod half_car;
pub mod harmonic_force;
pub mod harmonic_sum;
pub mod inertia;
pub mod jeffcott;
pub mod large_pendulum;
pub mod logarithmic_decrement;
pub mod mass_on_shaft;
pub mod modal_analysis;
pub mod multi_degree_response;
pub mod oscillator;
pub mod periodic_excitation;
pub mod piecewise_spring;
pub mod rayleigh_damping;
pub mod rotating_unbalance;
pub mod section;
pub mod shaft_clearance;
pub mod spring;
pub mod spring_network;
pub mod system;
pub mod torsional_train;
pub mod vibration_instrument;
pub mod vibration_isolation;
pub mod whirling_shaft;

mod sources;

dalembert_core::messages!("../locales/pt-BR.ftl");
