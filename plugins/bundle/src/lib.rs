//! Every analysis that comes with the program. A crate that depends on this one, and names it, links them all.

use dalembert_balancing as _;
use dalembert_rigid_body as _;
use dalembert_vibration as _;
use dalembert_virtual_work as _;
