//! Every analysis that comes with the program, and the course's lists of exercises. A crate that depends on this one, and names it, links them all.

use dalembert_balancing as _;
use dalembert_rigid_body as _;
use dalembert_vibration as _;
use dalembert_virtual_work as _;

dalembert_core::exercises!("../sets/lists-06-08.toml");
dalembert_core::exercises!("../sets/unit-ii.toml");
