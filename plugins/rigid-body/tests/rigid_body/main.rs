//! Rules, symmetries and ways there and back of the analyses.

mod solved;

mod arm_and_rod;
mod gyroscopes;
mod reactions;

use dalembert_rigid_body as _;
