//! A network of springs and dampers as a graph: what it gives under a load, at rest, under harmonic forces and by
//! itself.

use dalembert_core::{
    About, Analysis, Exhibit, Inputs, Reason, Reference, Refusal, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real, sdof, spring,
    vibration::network::{Network, NetworkError, SpringDamper},
};
use nalgebra::Complex;

mod checks;
mod drawing;
mod exhibits;

use crate::{
    shared::{
        decay::damped_frequency_error,
        spring::{Spring, network},
    },
    sources::RAO,
};

/// Nodes on one line of motion, and the springs and dampers between them.
#[derive(Clone, Debug, Inputs)]
pub struct SpringNetwork {
    /// Nodes.
    /// Points that move along one line; the ground is already included.
    #[input(min = 1)]
    pub nodes: Vec<NetworkNode>,
    /// Elements.
    #[input(min = 1)]
    pub elements: Vec<NetworkElement>,
    /// Loaded node.
    #[input(rows = "nodes")]
    pub loaded: Reference,
    /// Force on it.
    #[input("F", "N", positive, default = "1 N")]
    pub force: f64,
    /// Frequency of the force.
    /// Omit for a constant force.
    #[input("ω", "rad/s", positive)]
    pub frequency: Option<f64>,
}

/// A point that moves.
#[derive(Clone, Debug, Inputs)]
pub struct NetworkNode {
    /// Name.
    pub name: String,
    /// Mass.
    /// Omit for a joint.
    #[input("m", "kg", positive)]
    pub mass: Option<f64>,
}

/// Element between two nodes, or between a node and ground.
#[derive(Clone, Debug, Inputs)]
pub struct NetworkElement {
    /// From node.
    #[input(rows = "nodes")]
    pub from: Reference,
    /// To node.
    /// Omit for ground.
    #[input(rows = "nodes")]
    pub to: Option<Reference>,
    /// Kind.
    pub kind: ElementKind,
}

/// Type of an element.
#[derive(Clone, Debug, Inputs)]
pub enum ElementKind {
    /// Spring
    Spring {
        /// Spring.
        spring: Spring,
    },
    /// Damper
    Damper {
        /// Damping coefficient.
        #[input("c", "N*s/m", positive)]
        damping: f64,
    },
    /// Spring and damper in parallel
    KelvinVoigt {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
        /// Damping coefficient.
        #[input("c", "N*s/m", positive)]
        damping: f64,
    },
}

register!(SpringNetwork);

/// The most nodes and elements that are answered one by one.
const MOST: usize = 8;

impl Analysis for SpringNetwork {
    const ABOUT: About = About {
        id: "vibration/spring-network",
        title: "Network of springs and dampers",
        topic: "Stiffness and inertia",
        summary: "Stiffness at a node of any network of springs and dampers, at rest or under harmonic forces, what each element carries, and how masses on it vibrate.",
        main: &["displacement", "stiffness", "natural_frequency"],
        keywords: "graph node series parallel Kelvin-Voigt Maxwell dynamic stiffness bridge rubber felt pad rede de molas \
                   amortecedores nós rigidez dinâmica",
        sources: &[&RAO],
        cases: include_str!("../../cases/spring_network.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &SpringNetworkGiven<W>, sheet: W) -> Result<(), Refusal> {
        if self.nodes.len() > 50 {
            return Err(Refusal::because("there are more than 50 nodes: join some of them"));
        }
        let elements = self.elements(given, sheet)?;
        let system = self.system(&elements);
        self.at_rest(given, &system, &elements, sheet)?;
        if let Some(frequency) = given.frequency {
            self.harmonic_response(given, &system, frequency, sheet)?;
        }
        if self.nodes.iter().any(|node| node.mass.is_some()) {
            self.by_itself(given, &system, sheet)?;
        }
        sheet.show(|| Exhibit::Drawing(drawing::drawing(self)));
        sheet.show(|| Exhibit::Plot(self.receptance(&system)));
        Ok(())
    }
}

/// An element with its numbers.
struct Between<N> {
    stiffness: Option<N>,
    damping: Option<N>,
}

impl SpringNetwork {
    fn ends(&self, element: usize) -> [Option<usize>; 2] {
        let element = &self.elements[element];
        [Some(element.from.0), element.to.map(|node| node.0)]
    }

    fn elements<W: Worksheet>(
        &self,
        given: &SpringNetworkGiven<W>,
        sheet: W,
    ) -> Result<Vec<Between<W::Num>>, Refusal> {
        let mut elements = Vec::new();
        for (n, element) in given.elements.iter().enumerate() {
            if let [Some(from), Some(to)] = self.ends(n)
                && from == to
            {
                return Err(Refusal::because(
                    Text::new("element {element} begins and ends at {node}: write two different nodes")
                        .with("element", n + 1)
                        .with("node", &self.nodes[from].name),
                ));
            }
            elements.push(match &element.kind {
                ElementKindGiven::Spring { spring } => {
                    Between { stiffness: Some(network(spring, sheet, &[n + 1])?.stiffness), damping: None }
                }
                ElementKindGiven::Damper { damping } => Between { stiffness: None, damping: Some(*damping) },
                ElementKindGiven::KelvinVoigt { stiffness, damping } => {
                    Between { stiffness: Some(*stiffness), damping: Some(*damping) }
                }
            });
        }
        Ok(elements)
    }

    fn system<N: Real>(&self, elements: &[Between<N>]) -> Network {
        let links = elements.iter().enumerate().map(|(n, element)| SpringDamper {
            ends: self.ends(n),
            stiffness: element.stiffness.map_or(0.0, Real::value),
            damping: element.damping.map_or(0.0, Real::value),
        });
        Network {
            masses: self.nodes.iter().map(|node| node.mass.unwrap_or(0.0)).collect(),
            links: links.collect(),
        }
    }

    fn forces(&self) -> Vec<f64> {
        let mut forces = vec![0.0; self.nodes.len()];
        forces[self.loaded.0] = self.force;
        forces
    }

    /// Under the constant force, held by the springs.
    fn at_rest<W: Worksheet>(
        &self,
        given: &SpringNetworkGiven<W>,
        system: &Network,
        elements: &[Between<W::Num>],
        sheet: W,
    ) -> Result<(), Refusal> {
        let loaded = self.loaded.0;
        let found = match system.at_rest(&self.forces()) {
            Ok(found) => found,
            Err(NetworkError::Loose { node }) => {
                if system.links.iter().all(|link| link.damping == 0.0) {
                    return Err(self.refusal(&NetworkError::Loose { node }));
                }
                sheet.warn(|| {
                    Text::new("no spring restrains {node}: a constant force moves it without bound, so there is no static stiffness")
                        .with("node", &self.nodes[node].name)
                });
                return Ok(());
            }
            Err(error) => return Err(self.refusal(&error)),
        };
        let why = (
            "Static displacement under the force: at each node the spring forces balance the load",
            RAO.at("§1.7"),
        );
        let node = |(n, x): (usize, &f64)| {
            let why = if n == 0 { Reason::from(why) } else { Reason::from("Similarly") };
            sheet.numerical(("x", n + 1), "mm", *x, why)
        };
        let displacements: Vec<W::Num> = found.iter().enumerate().map(node).collect();
        let stiffnesses = || elements.iter().filter_map(|element| element.stiffness);
        if stiffnesses().count() > 1 {
            let added = || spring::parallel(stiffnesses());
            sheet.common_error("k", "all springs combined as if in parallel", added);
            let chained = || spring::series(stiffnesses());
            sheet.common_error("k", "all springs combined as if in series", chained);
        }
        let k = sheet.step(
            "k",
            "kN/m",
            given.force / displacements[loaded],
            ("Equivalent stiffness at the loaded node: force over displacement", RAO.at("§1.7")),
        );
        let mut forces = Vec::new();
        for (n, element) in elements.iter().enumerate() {
            let Some(stiffness) = element.stiffness else { continue };
            let deflection = match self.ends(n) {
                [Some(from), Some(to)] => displacements[from] - displacements[to],
                [Some(only), None] | [None, Some(only)] => displacements[only],
                [None, None] => continue,
            };
            let why = "Force in the spring, positive from its first node on";
            forces.push((n, sheet.step(("F", n + 1), "N", stiffness * deflection, why)));
        }
        sheet.verify(|| {
            sheet.check(
                "stiffness by eliminating the other nodes one by one (star and mesh)",
                W::Num::from(system.driving_point_stiffness(loaded, |link| Complex::from(link.stiffness)).re),
                k,
            );
            let (mut left, mut size) = (self.forces(), self.force);
            for (n, force) in &forces {
                let [from, to] = self.ends(*n);
                for (end, sign) in [(from, -1.0), (to, 1.0)] {
                    if let Some(end) = end {
                        left[end] += sign * force.value();
                    }
                }
                size = size.max(force.value().abs());
            }
            let worst = left.iter().fold(0.0, |worst: f64, x| worst.max(x.abs()));
            sheet.check_zero("the forces at every node add up to zero", W::Num::from(worst), size);
        });
        sheet.answer("stiffness", "Equivalent stiffness", k);
        for (n, x) in displacements.iter().enumerate().take(MOST) {
            sheet.answer(("displacement", n + 1), "Displacement of node", *x);
        }
        for (n, force) in forces.iter().filter(|(n, _)| *n < MOST) {
            sheet.answer(("force", n + 1), "Force in element", *force);
        }
        sheet.show(|| Exhibit::Table(self.table_at_rest(&found, &forces)));
        Ok(())
    }

    /// Under the harmonic force.
    fn harmonic_response<W: Worksheet>(
        &self,
        given: &SpringNetworkGiven<W>,
        system: &Network,
        frequency: W::Num,
        sheet: W,
    ) -> Result<(), Refusal> {
        let loaded = self.loaded.0;
        let omega = frequency.value();
        let moved = system.harmonic_response(&self.forces(), omega).map_err(|_| {
            Refusal::because(
                "the motion at this frequency grows without bound and has no steady state; add damping or change the frequency",
            )
        })?;
        let x = moved[loaded];
        let why = (
            "Complex amplitude of the loaded node, from the equilibrium of every node with k + iωc for each element and −mω² for each mass",
            RAO.at("§3.5"),
        );
        let real = sheet.numerical("X'", "mm", x.re, why);
        let imaginary = sheet.numerical("X''", "mm", x.im, "Its imaginary part");
        let size =
            sheet.step("X", "mm", (real.powi(2) + imaginary.powi(2)).sqrt(), "Amplitude of the loaded node");
        let lag = sheet.step("φ", "deg", (-imaginary).atan2(real), "The motion lags the force by");
        let square = real.powi(2) + imaginary.powi(2);
        let over_real = || given.force / real;
        sheet.common_error("k'", "the force divided by the real part of the displacement", over_real);
        let storage = sheet.step(
            "k'",
            "kN/m",
            given.force * real / square,
            "Real part of the dynamic stiffness F/X, masses included",
        );
        let over_imaginary = || -(given.force / imaginary);
        let what = "the force divided by the imaginary part of the displacement";
        sheet.common_error("k''", what, over_imaginary);
        let loss = sheet.step(
            "k''",
            "kN/m",
            -(given.force * imaginary / square),
            "Imaginary part of the dynamic stiffness: contribution of the dampers",
        );
        let dynamic = sheet.step("k_d", "kN/m", given.force / size, "Magnitude of the dynamic stiffness");
        sheet.answer("amplitude", "Amplitude of the loaded node", size);
        sheet.answer("phase", "Phase lag", lag);
        sheet.answer("dynamic_stiffness", "Dynamic stiffness", dynamic);
        sheet.answer("storage_stiffness", "Real part of the dynamic stiffness", storage);
        sheet.answer("loss_stiffness", "Imaginary part of the dynamic stiffness", loss);
        let mut factor = None;
        if storage.value() > 0.0 && loss.value() > 0.0 {
            let tangent = sheet.step("η", "1", loss / storage, "Loss factor");
            sheet.answer("loss_factor", "Loss factor", tangent);
            factor = Some(tangent);
        }
        sheet.verify(|| {
            let shown = checks::NodeResponse {
                force: given.force,
                amplitude: size,
                lag,
                storage,
                loss,
                dynamic,
                factor,
            };
            checks::harmonic_response(system, omega, &moved, &shown, sheet);
            if self.nodes.iter().enumerate().all(|(n, node)| n == loaded || node.mass.is_none()) {
                let driving_point = system.driving_point_stiffness(loaded, |link| {
                    Complex::new(link.stiffness, link.damping * omega)
                });
                let whole = driving_point - system.masses[loaded] * omega.powi(2);
                let off = (whole * Complex::new(real.value(), imaginary.value()) - self.force).norm();
                sheet.check_zero(
                    "dynamic stiffness by eliminating the other nodes one by one (star and mesh)",
                    W::Num::from(off),
                    self.force,
                );
            }
        });
        sheet.show(|| Exhibit::Table(self.table_excited(system, omega, &moved)));
        Ok(())
    }

    /// The masses moving by themselves.
    fn by_itself<W: Worksheet>(
        &self,
        given: &SpringNetworkGiven<W>,
        system: &Network,
        sheet: W,
    ) -> Result<(), Refusal> {
        let roots = system.roots().map_err(|error| self.refusal(&error))?;
        let heavy: Vec<usize> =
            (0..self.nodes.len()).filter(|node| self.nodes[*node].mass.is_some()).collect();
        if let ([only], true) = (&heavy[..], roots.len() > 1)
            && let Some(mass) = given.nodes[*only].mass
        {
            combined(system, *only, mass, sheet);
        }
        // A root belongs to an oscillation where its imaginary part is more than rounding.
        let mut oscillations: Vec<Complex<f64>> =
            roots.iter().copied().filter(|root| root.im > 1e-9 * root.norm()).collect();
        oscillations.sort_by(|p, q| p.norm().total_cmp(&q.norm()));
        let dashpots = system.links.iter().any(|link| link.damping > 0.0);
        let mut shown = Vec::new();
        for (n, root) in oscillations.iter().enumerate().take(MOST / 2) {
            let why = "Exact: frequency of the motion e^(st) that meets the equations of all nodes";
            let damped = sheet.numerical(("ω_d", n + 1), "rad/s", root.im, why);
            sheet.answer(("frequency", n + 1), "Exact frequency of free vibration", damped);
            let mut as_shown = Complex::new(0.0, damped.value());
            let mut damping_ratio = None;
            if dashpots {
                let decay = sheet.numerical(("σ", n + 1), "rad/s", -root.re + 0.0, "Its rate of decay");
                let tangent = || decay / damped;
                sheet.common_error(("ζ", n + 1), "the decay rate divided by the damped frequency", tangent);
                let ratio = sheet.step(
                    ("ζ", n + 1),
                    "1",
                    decay / (decay.powi(2) + damped.powi(2)).sqrt(),
                    ("Damping ratio of this root", RAO.at("§2.6")),
                );
                sheet.answer(("damping_ratio", n + 1), "Exact damping ratio", ratio);
                as_shown.re = -decay.value();
                damping_ratio = Some(ratio);
            }
            shown.push((as_shown, damping_ratio));
        }
        sheet.verify(|| {
            for (root, ratio) in &shown {
                checks::free(system, *root, *ratio, sheet);
            }
            if let [only] = heavy[..] {
                for (root, _) in &shown {
                    let driving_point =
                        system.driving_point_stiffness(only, |link| link.stiffness + link.damping * root);
                    let inertia = system.masses[only] * root * root;
                    sheet.check_zero(
                        "at the root the dynamic stiffness of the network balances the inertia of the mass",
                        W::Num::from((driving_point + inertia).norm()),
                        inertia.norm(),
                    );
                }
            }
            // Vieta: the sum of all roots of a damped system of masses is −Σ c/m where every node has mass.
            if heavy.len() == self.nodes.len() {
                let traces: f64 = system
                    .links
                    .iter()
                    .flat_map(|link| link.ends.into_iter().flatten().map(move |end| (end, link.damping)))
                    .map(|(end, damping)| damping / system.masses[end])
                    .sum();
                let sum: f64 = roots.iter().map(|root| root.re).sum();
                let size: f64 = roots.iter().map(|root| root.norm()).sum();
                sheet.check_zero("the sum of the roots is −Σ c/m", W::Num::from(sum + traces), size);
            }
        });
        if oscillations.is_empty() {
            sheet.warn(|| {
                Text::new("the dampers are so strong that nothing oscillates: every motion returns without oscillating")
            });
        }
        sheet.show(|| Exhibit::Table(exhibits::roots_table(&roots)));
        Ok(())
    }

    fn refusal(&self, error: &NetworkError) -> Refusal {
        match error {
            NetworkError::Loose { node } => Refusal::because(
                Text::new("{node} is unrestrained: join it to ground, directly or through other elements")
                    .with("node", &self.nodes[*node].name),
            ),
            NetworkError::Linear(_) => Refusal::because(
                "the stiffnesses, dampings and masses differ so much that no significant digits remain: omit the nearly rigid elements and join their nodes",
            ),
        }
    }
}

/// Springs and dampers combined apart from one another, as books do.
fn combined<W: Worksheet>(system: &Network, node: usize, mass: W::Num, sheet: W) {
    let driving_point = |of: fn(&SpringDamper) -> f64| {
        system.driving_point_stiffness(node, |link| Complex::from(of(link))).re
    };
    let (stiffness, damping) = (driving_point(|link| link.stiffness), driving_point(|link| link.damping));
    if stiffness <= 0.0 {
        return;
    }
    let k = sheet.numerical(
        "k_e",
        "kN/m",
        stiffness,
        ("The springs combined at the mass, as if there were no dampers", RAO.at("§1.7")),
    );
    let sum = || system.links.iter().map(|link| link.stiffness).sum::<f64>();
    let added = || (k * (sum() / stiffness) / mass).sqrt();
    sheet.common_error("ωₙ", "all springs combined as if in parallel", added);
    let compliance = || {
        let springs = system.links.iter().filter(|link| link.stiffness > 0.0);
        springs.map(|link| 1.0 / link.stiffness).sum::<f64>()
    };
    let chained = || (k / (stiffness * compliance()) / mass).sqrt();
    sheet.common_error("ωₙ", "all springs combined as if in series", chained);
    let natural = sheet.step(
        "ωₙ",
        "rad/s",
        sdof::natural_frequency(k, mass),
        ("Natural frequency without damping", RAO.at("§2.2")),
    );
    sheet.answer("natural_frequency", "Natural frequency without damping", natural);
    sheet.verify(|| {
        let mut unit = vec![0.0; system.masses.len()];
        unit[node] = 1.0;
        if let Ok(x) = system.at_rest(&unit) {
            sheet.check("the displacement under a unit force is 1/k", W::Num::from(1.0 / x[node]), k);
        }
        if let Some(energy) = checks::elastic(system, node) {
            sheet.check(
                "springs alone: maximum kinetic energy = maximum elastic energy",
                mass * natural.powi(2),
                W::Num::from(energy),
            );
        }
    });
    if damping <= 0.0 {
        return;
    }
    let c = sheet.numerical(
        "c_e",
        "N*s/m",
        damping,
        ("The dampers combined in the same way, as if there were no springs", RAO.at("§1.9")),
    );
    let ratio = sheet.step(
        "ζ",
        "1",
        sdof::damping_ratio(c, k, mass),
        ("Damping ratio: damping over critical damping", RAO.at("§2.6")),
    );
    sheet.verify(|| {
        if let Some(power) = checks::elastic(&checks::dampers_alone(system), node) {
            sheet.check("dampers alone: power dissipated at unit velocity is c", W::Num::from(power), c);
        }
        sheet.check("combined separately: the sum of the roots is −c/m", ratio * natural * 2.0, c / mass);
    });
    sheet.answer("combined_damping", "Damping, dampers combined separately from the springs", c);
    sheet.answer("combined_damping_ratio", "Damping ratio, springs and dampers combined separately", ratio);
    if ratio.value() < 1.0 {
        damped_frequency_error("ω_d", natural, ratio, sheet);
        let damped = sheet.step(
            "ω_d",
            "rad/s",
            sdof::damped_frequency(natural, ratio),
            ("Frequency of the decaying motion", RAO.at("§2.6")),
        );
        sheet.check(
            "combined separately: the product of the roots is k/m",
            (ratio * natural).powi(2) + damped.powi(2),
            k / mass,
        );
        sheet.answer(
            "combined_frequency",
            "Damped frequency, springs and dampers combined separately",
            damped,
        );
    }
    if system.links.iter().filter(|link| link.damping > 0.0 || link.stiffness > 0.0).count() > 1 {
        sheet.warn(|| {
            Text::new(
                "springs and dampers combined separately are exact only if c/k is the same in every element; the exact roots are also given",
            )
        });
    }
}
