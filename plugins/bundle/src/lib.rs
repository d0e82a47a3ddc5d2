//! Every analysis that comes with the program, the course's lists of exercises, and exam questions of several steps or of an optimum. A crate that depends on this one, and names it, links them all.

use dalembert_balancing as _;
use dalembert_rigid_body as _;
use dalembert_vibration as _;
use dalembert_virtual_work as _;

dalembert_core::exercises!("../sets/lists-06-08.toml");
dalembert_core::exercises!("../sets/unit-ii.toml");
dalembert_core::exercises!("../sets/virtual-work-in-statics.toml");
dalembert_core::exercises!("../sets/linkages.toml");
dalembert_core::exercises!("../sets/engines-cams-and-gears.toml");
dalembert_core::exercises!("../sets/balancing-of-rotors.toml");
dalembert_core::exercises!("../sets/balancing-of-engines.toml");
dalembert_core::exercises!("../sets/gyroscopes-and-vehicles.toml");
dalembert_core::exercises!("../sets/bodies-in-space.toml");
dalembert_core::exercises!("../sets/free-vibration.toml");
dalembert_core::exercises!("../sets/forced-vibration.toml");
dalembert_core::exercises!("../sets/several-degrees-of-freedom.toml");

dalembert_core::exams!("../exams":
    "absorber-for-an-unknown-machine",
    "absorber-with-least-peak",
    "counterweights-of-a-four-bar",
    "diesel-generator-torsion",
    "engine-shaking-force",
    "fan-on-cantilever-bracket",
    "four-bar-through-five-points",
    "grinding-wheel-balance",
    "instrument-case-dropped",
    "instrument-table-on-softer-springs",
    "isolators-from-a-list",
    "lift-table-with-screw-drive",
    "lightest-shaft-within-clearance",
    "motor-on-a-measured-beam",
    "overhung-impeller",
    "racing-car-on-a-wavy-road",
    "rotor-balanced-in-two-planes",
    "satellite-after-a-pulse",
    "ship-turbine-gyroscopic-load",
    "slide-with-dry-friction",
    "toggle-press-with-flywheel",
    "top-on-its-tip",
    "turbine-disc-critical-speed",
    "vibrometer-finds-an-unbalance",
    "walking-beam-pump",
);

dalembert_core::messages!("../locales/pt-BR.ftl");
