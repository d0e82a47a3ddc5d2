//! The wheels of a vehicle, and their loads as they depend on the speed.

/// A wheel, and how it shares what the vehicle has to carry.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wheel {
    pub(super) symbol: &'static str,
    pub(super) name: &'static str,
    pub(super) label: &'static str,
    /// The label of the speed at which it lifts.
    pub(super) lifts: &'static str,
    pub(super) front: bool,
    pub(super) outer: bool,
    /// Share of this wheel in all loads.
    share: f64,
    /// Share of its axle in the load that goes to the outer side.
    transfer: f64,
    /// +1 on the front axle, −1 on the rear one, 0 where axles are alike.
    pitch: f64,
}

/// The parts of the loads: at rest, and per square of speed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constants {
    /// All loads together.
    pub(super) normal: (f64, f64),
    /// Load transfer from the inner to the outer side.
    pub(super) transfer: (f64, f64),
    /// Load that goes from the rear to the front axle, per square of speed.
    pub(super) pitching: f64,
}

impl Constants {
    /// Load of a wheel at a speed.
    pub(super) fn load(&self, wheel: &Wheel, speed: f64) -> f64 {
        let (rest, gain) = self.parts(wheel);
        rest + gain * speed.powi(2)
    }

    /// The speed at which a wheel that carries load at rest has none left.
    pub(super) fn lifting_speed(&self, wheel: &Wheel) -> Option<f64> {
        let (rest, gain) = self.parts(wheel);
        let speed = (rest / -gain).sqrt();
        (rest > 0.0 && gain < 0.0 && speed.is_finite()).then_some(speed)
    }

    fn parts(&self, wheel: &Wheel) -> (f64, f64) {
        let outwards = if wheel.outer { wheel.transfer } else { -wheel.transfer };
        let part = |normal: f64, transfer: f64| normal * wheel.share + transfer * outwards;
        let pitch = self.pitching * wheel.pitch / 2.0;
        (part(self.normal.0, self.transfer.0), part(self.normal.1, self.transfer.1) + pitch)
    }
}

/// The inner and the outer wheel of axles that are alike, each with its share of the load transfer.
pub(super) fn alike(transfer: f64) -> Vec<Wheel> {
    let inner = Wheel {
        symbol: "N_i",
        name: "inner_load",
        label: "Load of each inner wheel",
        lifts: "Speed at which the inner wheels lift",
        front: true,
        outer: false,
        share: transfer / 2.0,
        transfer,
        pitch: 0.0,
    };
    let outer = Wheel {
        symbol: "N_o",
        name: "outer_load",
        label: "Load of each outer wheel",
        lifts: "Speed at which the outer wheels lift",
        outer: true,
        ..inner
    };
    vec![inner, outer]
}

/// The four wheels of two axles, with the shares of the front axle in all loads and in the load transfer.
pub(super) fn four(share: f64, transfer: f64) -> Vec<Wheel> {
    let front = Wheel {
        symbol: "N_fi",
        name: "front_inner_load",
        label: "Load of the front inner wheel",
        lifts: "Speed at which the front inner wheel lifts",
        front: true,
        outer: false,
        share: share / 2.0,
        transfer,
        pitch: 1.0,
    };
    let rear = Wheel {
        symbol: "N_ri",
        name: "rear_inner_load",
        label: "Load of the rear inner wheel",
        lifts: "Speed at which the rear inner wheel lifts",
        front: false,
        share: (1.0 - share) / 2.0,
        transfer: 1.0 - transfer,
        pitch: -1.0,
        ..front
    };
    vec![
        front,
        Wheel {
            symbol: "N_fo",
            name: "front_outer_load",
            label: "Load of the front outer wheel",
            lifts: "Speed at which the front outer wheel lifts",
            outer: true,
            ..front
        },
        rear,
        Wheel {
            symbol: "N_ro",
            name: "rear_outer_load",
            label: "Load of the rear outer wheel",
            lifts: "Speed at which the rear outer wheel lifts",
            outer: true,
            ..rear
        },
    ]
}
