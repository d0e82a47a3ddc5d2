//! Strings, beams and plates.

pub mod beam_vibration;
pub mod beam_with_tip_body;
pub mod multi_span_beam;
pub mod plane_frame;
pub mod plate_and_membrane;
pub mod rotating_beam;
pub mod string_rod_shaft;
pub mod tapered_beam;
