//! Efforts, motions and places of rest, each found in two ways, and what is refused.

mod chains;
mod driven;
mod mechanism;
mod solved;

mod statics;
mod templates;
mod virtual_power;

use dalembert_virtual_work as _;
