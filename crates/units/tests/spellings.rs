//! Numbers, units and vectors as people write them in the United States, in Britain, in Brazil and in books: each is read
//! right, or refused with repairs that are read right when they are typed.
// Long because it is the table of spellings.

use std::f64::consts::{PI, TAU};

use dalembert_units::{Kind, ReadError, read_quantity, read_vector, unit};

use self::Outcome::{Read, Refused};

/// Expected outcome of a text in a field.
enum Outcome {
    /// The value in SI.
    Read(f64),
    /// A refusal: repairs that its message shows, each with the value in SI that typing it gives.
    Refused(&'static [(&'static str, f64)]),
}

// The definitions: international yard and pound agreement of 1959, 3rd CGPM 1901, NIST SP 811 (2008), appendix B.
const IN: f64 = 0.0254;
const FT: f64 = 0.3048;
const LB: f64 = 0.453_592_37;
const OZ: f64 = LB / 16.0;
const G0: f64 = 9.806_65;
const LBF: f64 = LB * G0;
const PSI: f64 = LBF / (IN * IN);
const SLUG: f64 = LBF / FT;
const DEG: f64 = PI / 180.0;
const RPM: f64 = TAU / 60.0;

/// Text, unit of the field, and what it gives.
#[rustfmt::skip]
const QUANTITIES: &[(&str, &str, Outcome)] = &[
    // Numbers
    ("20.3 mm", "m", Read(0.0203)), ("20,3 mm", "m", Read(0.0203)), ("20.3mm", "m", Read(0.0203)), ("+.5 m", "m", Read(0.5)),
    ("−5 m", "m", Read(-5.0)), ("1e3 N", "N", Read(1e3)), ("1E-3 N", "N", Read(1e-3)), ("1.5x10^-3 m", "m", Read(0.0015)),
    ("1.5 x 10^3 N", "N", Read(1500.0)), ("1.5×10⁻³ m", "m", Read(0.0015)), ("1,5·10^3 N", "N", Read(1500.0)),
    ("1.5*10**3 N", "N", Read(1500.0)), ("1.5 10^3 N", "N", Read(1500.0)), ("1.5 10⁻³ m", "m", Read(0.0015)),
    ("1.5e−3 m", "m", Read(0.0015)), ("10^3 N", "N", Read(1000.0)), ("12\u{202f}345 N", "N", Read(12345.0)),
    ("12\u{2009}345,5 N", "N", Read(12345.5)), ("1\u{a0}000\u{a0}000 N", "N", Read(1e6)), ("1234,5 N", "N", Read(1234.5)),
    ("1,250 kg", "kg", Refused(&[("1250", 1250.0), ("1.250", 1.25)])),
    ("1.234,5 mm", "m", Refused(&[("1234.5", 1.2345), ("1.2345", 0.001_234_5)])),
    ("1 000 mm", "m", Read(1.0)), ("12 500,5 N", "N", Read(12500.5)), ("12 500.5 N", "N", Read(12500.5)), ("1 000 000 N", "N", Read(1e6)),
    ("−1 500 N", "N", Read(-1500.0)), ("2*1 500 N", "N", Read(3000.0)), ("1 234,567 N", "N", Read(1234.567)), ("1 500 rev/min", "rad/s", Read(1500.0 * RPM)),
    ("1 0000 N", "N", Refused(&[("10000", 1e4)])), ("1 000 50 N", "N", Refused(&[("100050", 100_050.0)])), ("1234 567 N", "N", Refused(&[("1234567", 1_234_567.0)])),
    ("0.123 456 m", "m", Refused(&[("0.123456", 0.123_456)])), ("5 125/1000 m", "m", Read(5.125)), ("5 100/200 m", "m", Read(5.5)),
    ("½ in", "m", Read(IN / 2.0)), ("¼ in", "m", Read(IN / 4.0)), ("¾in", "m", Read(IN * 0.75)), ("5½ in", "m", Read(5.5 * IN)),
    ("5 ½ in", "m", Read(5.5 * IN)), ("−2¼ in", "m", Read(-2.25 * IN)), ("⅜ in", "m", Read(0.375 * IN)), ("2*½ m", "m", Read(1.0)),
    ("½ lbf-in", "N*m", Read(LBF * IN / 2.0)), ("5 ft + 3½ in", "m", Read(5.0 * FT + 3.5 * IN)), ("2.5½ in", "m", Refused(&[])),
    ("1.3×10-6 m", "m", Refused(&[("1.3*10^-6", 1.3e-6)])),
    ("1/2 in", "m", Read(IN / 2.0)), ("5 1/2 in", "m", Read(5.5 * IN)), ("3/8 in", "m", Read(0.375 * IN)),
    ("5 ft + 3 in", "m", Read(5.25 * FT)), ("5 ft 3 in", "m", Refused(&[("5 ft + 3 in", 5.25 * FT)])),
    ("5'3\"", "m", Refused(&[("5 ft + 3 in", 5.25 * FT)])), ("6'", "m", Refused(&[("6 ft", 6.0 * FT)])),
    ("30°15'", "deg", Read(30.25 * DEG)), ("2 pi rad", "rad", Read(TAU)),
    ("pi/2", "deg", Refused(&[("(pi/2) rad", PI / 2.0), ("(pi/2) deg", PI / 2.0 * DEG)])),
    ("5 lb + 3 lbf", "N", Refused(&[("5 lbf + 3 lbf", 8.0 * LBF)])), ("5 lb + 3 lbf", "kg", Refused(&[("5 lb + 3 lb", 8.0 * LB)])),
    ("10 kgf - 2 kg", "N", Refused(&[("10 kgf - 2 kgf", 8.0 * G0)])), ("2 g0 + 9.80665 m/s^2", "m/s^2", Read(3.0 * G0)),
    ("2 g + 1 m/s^2", "m/s^2", Refused(&[("2 g0 + 1 m/s^2", 2.0 * G0 + 1.0)])), ("(5 lb + 3 lbf)*2 m", "N*m", Refused(&[("5 lbf + 3 lbf", 16.0 * LBF)])),
    // Length
    ("3 m", "m", Read(3.0)), ("3 metres", "m", Read(3.0)), ("3 meters", "m", Read(3.0)), ("3 metros", "m", Read(3.0)),
    ("25 milímetros", "m", Read(0.025)), ("25 millimeters", "m", Read(0.025)), ("25 centímetros", "m", Read(0.25)),
    ("2 quilômetros", "m", Read(2000.0)), ("2 kilometres", "m", Read(2000.0)), ("40 micrometers", "m", Read(4e-5)),
    ("40 microns", "m", Read(4e-5)), ("40 mícrons", "m", Read(4e-5)), ("40 µm", "m", Read(4e-5)), ("40 um", "m", Read(4e-5)),
    ("3 in", "m", Read(3.0 * IN)), ("3 inches", "m", Read(3.0 * IN)), ("3 polegadas", "m", Read(3.0 * IN)),
    ("3 pol", "m", Read(3.0 * IN)), ("3 ft", "m", Read(3.0 * FT)), ("3 feet", "m", Read(3.0 * FT)), ("3 pés", "m", Read(3.0 * FT)),
    ("3 yards", "m", Read(9.0 * FT)), ("3 jardas", "m", Read(9.0 * FT)), ("2 miles", "m", Read(10560.0 * FT)),
    ("2 milhas", "m", Read(10560.0 * FT)), ("5 mil", "m", Read(0.005 * IN)), ("5 thou", "m", Read(0.005 * IN)),
    ("20 MM", "m", Refused(&[("mm", 0.02)])), ("20 metrs", "m", Refused(&[("metres", 20.0)])),
    // Mass
    ("35 g", "kg", Read(0.035)), ("35 grams", "kg", Read(0.035)), ("35 gramas", "kg", Read(0.035)), ("2 kg", "kg", Read(2.0)),
    ("2 kilograms", "kg", Read(2.0)), ("2 quilogramas", "kg", Read(2.0)), ("5 miligramas", "kg", Read(5e-6)),
    ("2 Kg", "kg", Refused(&[("kg", 2.0)])), ("2 KG", "kg", Refused(&[("kg", 2.0)])), ("2 t", "kg", Read(2000.0)),
    ("2 tonnes", "kg", Read(2000.0)), ("2 toneladas", "kg", Read(2000.0)), ("2 metric tons", "kg", Read(2000.0)),
    ("0.3 ton", "kg", Refused(&[("short ton", 600.0 * LB), ("long ton", 672.0 * LB), ("t", 300.0)])),
    ("2 tons", "kg", Refused(&[("short ton", 4000.0 * LB), ("long ton", 4480.0 * LB), ("t", 2000.0)])),
    ("0.3 long ton", "kg", Read(672.0 * LB)), ("2 long tons", "kg", Read(4480.0 * LB)), ("2 UK tons", "kg", Read(4480.0 * LB)),
    ("0.3 short ton", "kg", Read(600.0 * LB)), ("2 short tons", "kg", Read(4000.0 * LB)), ("2 US tons", "kg", Read(4000.0 * LB)),
    ("3 cwt", "kg", Refused(&[("short cwt", 300.0 * LB), ("long cwt", 336.0 * LB)])),
    ("3 short cwt", "kg", Read(300.0 * LB)), ("3 long cwt", "kg", Read(336.0 * LB)),
    ("20 lb", "kg", Read(20.0 * LB)), ("20 lbm", "kg", Read(20.0 * LB)), ("20 lbs", "kg", Read(20.0 * LB)),
    ("20 pounds", "kg", Read(20.0 * LB)), ("20 libras", "kg", Read(20.0 * LB)), ("8 oz", "kg", Read(8.0 * OZ)),
    ("8 ounces", "kg", Read(8.0 * OZ)), ("8 onças", "kg", Read(8.0 * OZ)), ("2 slugs", "kg", Read(2.0 * SLUG)),
    ("10 lbf", "kg", Refused(&[("10 lb", 10.0 * LB)])), ("10 kgf", "kg", Refused(&[("10 kg", 10.0)])),
    ("98.1 N", "kg", Refused(&[("98.1/9.81 kg", 10.0)])), ("1 lb*s^2/in", "kg", Refused(&[("1 lbf*s^2/in", LBF / IN)])),
    ("1 lbf*s^2/in", "kg", Read(LBF / IN)), ("1 lbf-s^2/in", "kg", Read(LBF / IN)),
    ("0.0259 kip*s^2/in", "kg", Read(25.9 * LBF / IN)), ("1 lb-s^2/in", "kg", Refused(&[("1 lbf-s^2/in", LBF / IN)])),
    // Time
    ("3 s", "s", Read(3.0)), ("1 second", "s", Read(1.0)), ("1 segundo", "s", Read(1.0)), ("1 millisecond", "s", Read(0.001)),
    ("1 milissegundo", "s", Read(0.001)), ("1 minute", "s", Read(60.0)), ("1 minuto", "s", Read(60.0)), ("1 hour", "s", Read(3600.0)),
    ("1 hora", "s", Read(3600.0)), ("½ hour", "s", Read(1800.0)), ("1500 rev/minute", "rad/s", Read(1500.0 * RPM)),
    ("3 sec", "s", Read(3.0)), ("3 seconds", "s", Read(3.0)), ("3 segundos", "s", Read(3.0)),
    ("30 milissegundos", "s", Read(0.03)), ("30 milliseconds", "s", Read(0.03)), ("3 min", "s", Read(180.0)),
    ("3 minutos", "s", Read(180.0)), ("3 minutes", "s", Read(180.0)), ("2 h", "s", Read(7200.0)), ("2 hr", "s", Read(7200.0)),
    ("2 hours", "s", Read(7200.0)), ("2 horas", "s", Read(7200.0)), ("2 dias", "s", Read(172_800.0)),
    // Angles, speeds of rotation, frequencies
    ("30 deg", "rad", Read(30.0 * DEG)), ("30°", "rad", Read(30.0 * DEG)), ("30 degrees", "rad", Read(30.0 * DEG)),
    ("30 graus", "rad", Read(30.0 * DEG)), ("2 radians", "rad", Read(2.0)), ("2 radianos", "rad", Read(2.0)),
    ("2 rev", "rad", Read(2.0 * TAU)), ("2 voltas", "rad", Read(2.0 * TAU)), ("2 revolutions", "rad", Read(2.0 * TAU)),
    ("30 %", "rad", Refused(&[])), ("7 dg", "rad", Refused(&[("7 deg", 7.0 * DEG)])),
    ("1500 rpm", "rad/s", Read(1500.0 * RPM)), ("1500 rev/min", "rad/s", Read(1500.0 * RPM)),
    ("1500 r/min", "rad/s", Read(1500.0 * RPM)), ("1500 rotações/min", "rad/s", Read(1500.0 * RPM)),
    ("1500 rpm", "Hz", Read(1500.0 * RPM)), ("1500 RPM", "rad/s", Refused(&[("rpm", 1500.0 * RPM)])),
    ("500 cpm", "Hz", Read(500.0 * RPM)), ("500 cycles/min", "Hz", Read(500.0 * RPM)), ("500 c/min", "Hz", Read(500.0 * RPM)),
    ("8 Hz", "Hz", Read(8.0 * TAU)), ("8 hertz", "Hz", Read(8.0 * TAU)), ("8 kilohertz", "Hz", Read(8000.0 * TAU)),
    ("8.33 c/s", "Hz", Read(8.33 * TAU)), ("8.33 cps", "Hz", Read(8.33 * TAU)), ("8.33 cycles/s", "Hz", Read(8.33 * TAU)),
    ("8.33 ciclos/s", "Hz", Read(8.33 * TAU)), ("8.33 cycle/sec", "Hz", Read(8.33 * TAU)), ("8 hz", "Hz", Refused(&[("Hz", 8.0 * TAU)])),
    ("2 rad s⁻¹", "rad/s", Read(2.0)), ("2 s⁻¹", "rad/s", Read(2.0)), ("2 rev/s^2", "rad/s^2", Read(2.0 * TAU)),
    ("1/0.5 s", "rad/s", Refused(&[("1/(0.5 s)", 2.0)])),
    // Velocity and acceleration
    ("60 mph", "m/s", Read(26.8224)), ("60 km/h", "m/s", Read(60.0 / 3.6)), ("60 kph", "m/s", Read(60.0 / 3.6)),
    ("60 kmh", "m/s", Read(60.0 / 3.6)), ("60 quilômetros/h", "m/s", Read(60.0 / 3.6)), ("60 fps", "m/s", Read(60.0 * FT)),
    ("60 ft/s", "m/s", Read(60.0 * FT)), ("60 ips", "m/s", Read(60.0 * IN)), ("20 knots", "m/s", Read(20.0 * 1852.0 / 3600.0)),
    ("20 nós", "m/s", Read(20.0 * 1852.0 / 3600.0)), ("3 m/sec", "m/s", Read(3.0)), ("60 Km/h", "m/s", Refused(&[("km", 60.0 / 3.6)])),
    ("32.2 ft/s^2", "m/s^2", Read(32.2 * FT)), ("32.2 ft/sec²", "m/s^2", Read(32.2 * FT)), ("386 in/s/s", "m/s^2", Read(386.0 * IN)),
    ("0.5 g", "m/s^2", Refused(&[("0.5 g0", 0.5 * G0)])), ("0.5 g's", "m/s^2", Read(0.5 * G0)), ("0.5 gn", "m/s^2", Read(0.5 * G0)),
    ("980 cm/s2", "m/s^2", Read(9.8)), ("0.04 g^2/Hz", "(m/s^2)^2/Hz", Refused(&[("0.04 g0^2/Hz", 0.04 * G0 * G0 / TAU)])),
    ("0.04 g0^2/Hz", "(m/s^2)^2/Hz", Read(0.04 * G0 * G0 / TAU)),
    // Force
    ("20 N", "N", Read(20.0)), ("20 newtons", "N", Read(20.0)), ("20 quilonewtons", "N", Read(2e4)), ("20 kilonewtons", "N", Read(2e4)),
    ("20 lbf", "N", Read(20.0 * LBF)), ("20 lb", "N", Refused(&[("20 lbf", 20.0 * LBF)])), ("20 lbs", "N", Refused(&[("20 lbf", 20.0 * LBF)])),
    ("20 pounds", "N", Refused(&[("20 lbf", 20.0 * LBF)])), ("20 pounds-force", "N", Read(20.0 * LBF)),
    ("20 libras-força", "N", Read(20.0 * LBF)), ("8 oz", "N", Refused(&[("8 ozf", 8.0 * OZ * G0)])), ("3 kips", "N", Read(3000.0 * LBF)),
    ("20 kgf", "N", Read(20.0 * G0)), ("20 quilogramas-força", "N", Read(20.0 * G0)), ("20 kp", "N", Read(20.0 * G0)),
    ("10 kg", "N", Refused(&[("9.81*10 N", 98.1), ("10 kgf", 10.0 * G0)])),
    ("3 tf", "N", Read(3000.0 * G0)), ("3 toneladas-força", "N", Read(3000.0 * G0)),
    ("3 tonf", "N", Refused(&[("short tonf", 6000.0 * LBF), ("long tonf", 6720.0 * LBF), ("tf", 3000.0 * G0)])),
    ("3 ton", "N", Refused(&[("short tonf", 6000.0 * LBF), ("long tonf", 6720.0 * LBF), ("tf", 3000.0 * G0)])),
    ("3 ton-force", "N", Refused(&[("short tonf", 6000.0 * LBF), ("long tonf", 6720.0 * LBF), ("tf", 3000.0 * G0)])),
    ("3 short tonf", "N", Read(6000.0 * LBF)), ("3 long tonf", "N", Read(6720.0 * LBF)),
    ("3 short ton", "N", Refused(&[("3 short tonf", 6000.0 * LBF)])), ("20 KN", "N", Refused(&[("kN", 2e4)])),
    // Stiffness, damping, mass per length, density
    ("2000 lb/ft", "N/m", Refused(&[("2000 lbf/ft", 2000.0 * LBF / FT)])), ("15000 lb/in", "N/m", Refused(&[("15000 lbf/in", 15000.0 * LBF / IN)])),
    ("15000 lb/in.", "N/m", Refused(&[])), ("15 kips/in", "N/m", Read(15000.0 * LBF / IN)), ("100 lbf/in", "N/m", Read(100.0 * LBF / IN)),
    ("20 kg/cm", "N/m", Refused(&[("20 kgf/cm", 2000.0 * G0)])), ("20 kgf/cm", "N/m", Read(2000.0 * G0)), ("3 N/mm", "N/m", Read(3000.0)),
    ("3 newtons/metro", "N/m", Read(3.0)), ("2 ton/in", "N/m", Refused(&[("short tonf", 4000.0 * LBF / IN), ("long tonf", 4480.0 * LBF / IN)])),
    ("10 lb*s/in", "N*s/m", Refused(&[("10 lbf*s/in", 10.0 * LBF / IN)])), ("10 lb-s/in", "N*s/m", Refused(&[("10 lbf-s/in", 10.0 * LBF / IN)])),
    ("10 lbf-s/in", "N*s/m", Read(10.0 * LBF / IN)), ("52 Ns/m", "N*s/m", Read(52.0)), ("52 N.s/m", "N*s/m", Read(52.0)), ("52 kN-s/m", "N*s/m", Read(52e3)),
    ("52 N s/m", "N*s/m", Read(52.0)), ("3 N/m s", "kg/s", Refused(&[])), ("3 lbf/ft", "kg/m", Refused(&[("3 lb/ft", 3.0 * LB / FT)])),
    ("0.00073 lb*s^2/in^4", "kg/m^3", Refused(&[("0.00073 lbf*s^2/in^4", 0.00073 * LBF / (IN * IN * IN * IN))])),
    ("0.284 lb/in^3", "kg/m^3", Read(0.284 * LB / (IN * IN * IN))), ("0.284 lb/in³", "kg/m^3", Read(0.284 * LB / (IN * IN * IN))),
    ("490 lb/ft3", "kg/m^3", Read(490.0 * LB / (FT * FT * FT))), ("490 lbf/ft^3", "kg/m^3", Refused(&[("490 lb/ft^3", 490.0 * LB / (FT * FT * FT))])),
    ("7,85 g/cm³", "kg/m^3", Read(7850.0)), ("7.85 t/m^3", "kg/m^3", Read(7850.0)), ("15.2 slug/ft^3", "kg/m^3", Read(15.2 * SLUG / (FT * FT * FT))),
    // Torque, energy, power
    ("25 N-m", "N*m", Read(25.0)), ("25 N·m", "N*m", Read(25.0)), ("25 N.m", "N*m", Read(25.0)), ("25 Nm", "N*m", Read(25.0)), ("25 N m", "N*m", Read(25.0)),
    ("25 kN-m", "N*m", Read(25e3)), ("25 newtons-metro", "N*m", Read(25.0)), ("25 ft-lbf", "N*m", Read(25.0 * FT * LBF)),
    ("25 lbf-ft", "N*m", Read(25.0 * FT * LBF)), ("25 lb-ft", "N*m", Refused(&[("25 lbf-ft", 25.0 * FT * LBF)])),
    ("25 ft-lb", "N*m", Refused(&[("25 ft-lbf", 25.0 * FT * LBF)])), ("25 in-lb", "N*m", Refused(&[("25 in-lbf", 25.0 * IN * LBF)])),
    ("25 lb*in", "N*m", Refused(&[("25 lbf*in", 25.0 * IN * LBF)])), ("25 in-lbf", "N*m", Read(25.0 * IN * LBF)),
    ("25 ftlb", "N*m", Refused(&[("ft*lbf", 25.0 * FT * LBF)])), ("25 inlb", "N*m", Refused(&[("in*lbf", 25.0 * IN * LBF)])),
    ("25 oz-in", "N*m", Refused(&[("25 ozf-in", 25.0 * OZ * G0 * IN)])), ("25 kgf.m", "N*m", Read(25.0 * G0)), ("25 kgf-m", "N*m", Read(25.0 * G0)),
    ("25 kgfm", "N*m", Read(25.0 * G0)), ("25 kg-m", "N*m", Refused(&[("25 kgf-m", 25.0 * G0)])), ("25 kgm", "N*m", Refused(&[("kgf*m", 25.0 * G0)])),
    ("3 kip-ft", "N*m", Read(3000.0 * FT * LBF)), ("3 kJ", "N*m", Refused(&[("3000 N*m", 3000.0)])), ("3 joules", "J", Read(3.0)),
    ("3 kW-h", "J", Read(3.0 * 3.6e6)), ("3 ft-lb", "J", Refused(&[("3 ft-lbf", 3.0 * FT * LBF)])), ("3 hp", "W", Read(1650.0 * FT * LBF)),
    ("3 horsepower", "W", Read(1650.0 * FT * LBF)), ("3 HP", "W", Refused(&[("hp", 1650.0 * FT * LBF)])), ("3 cv", "W", Read(225.0 * G0)),
    ("3 watts", "W", Read(3.0)), ("3 megawatts", "W", Read(3e6)), ("3 ft-lbf/s", "W", Read(3.0 * FT * LBF)),
    ("10 lb*in/rad", "N*m/rad", Refused(&[("10 lbf*in/rad", 10.0 * LBF * IN)])), ("10 N-m/rad", "N*m/rad", Read(10.0)), ("10 Nm/rad", "N*m/rad", Read(10.0)),
    ("10 N·m/°", "N*m/rad", Read(10.0 / DEG)), ("10 Nms/rad", "N*m*s/rad", Read(10.0)), ("3 Ns", "N*s", Read(3.0)),
    // Stress
    ("30 MPa", "Pa", Read(30e6)), ("30 Mpa", "Pa", Refused(&[("MPa", 30e6)])), ("30 megapascals", "Pa", Read(30e6)), ("30 N/mm²", "Pa", Read(30e6)),
    ("30 N/mm2", "Pa", Read(30e6)), ("30 psi", "Pa", Read(30.0 * PSI)), ("30 PSI", "Pa", Refused(&[("psi", 30.0 * PSI)])), ("30 ksi", "Pa", Read(30e3 * PSI)),
    ("30 msi", "Pa", Read(30e6 * PSI)), ("30 Msi", "Pa", Read(30e6 * PSI)), ("30e6 psi", "Pa", Read(30e6 * PSI)), ("30x10^6 lbf/in^2", "Pa", Read(30e6 * PSI)),
    ("30 lb/in^2", "Pa", Refused(&[("30 lbf/in^2", 30.0 * PSI)])), ("30 lb/in2", "Pa", Refused(&[("30 lbf/in2", 30.0 * PSI)])), ("60 psf", "Pa", Read(60.0 * LBF / (FT * FT))),
    ("30 kgf/cm²", "Pa", Read(30e4 * G0)), ("30 kg/cm²", "Pa", Refused(&[("30 kgf/cm²", 30e4 * G0)])), ("30 kgf/mm2", "Pa", Read(30e6 * G0)), ("3 bar", "Pa", Read(3e5)),
    ("15 long tonf/in^2", "Pa", Read(15.0 * 2240.0 * PSI)), ("15 tonf/in^2", "Pa", Refused(&[("long tonf", 15.0 * 2240.0 * PSI)])),
    // Moments of inertia, unbalances
    ("40 lb-in^2", "kg*m^2", Read(40.0 * LB * IN * IN)), ("40 lb ft2", "kg*m^2", Read(40.0 * LB * FT * FT)), ("40 lb-ft²", "kg*m^2", Read(40.0 * LB * FT * FT)),
    ("50 lb*in*s^2", "kg*m^2", Refused(&[("50 lbf*in*s^2", 50.0 * LBF * IN)])), ("1.24 lb*ft*s^2", "kg*m^2", Refused(&[("1.24 lbf*ft*s^2", 1.24 * LBF * FT)])),
    ("1.24 slug-ft^2", "kg*m^2", Read(1.24 * SLUG * FT * FT)), ("50 lbf-in-s^2", "kg*m^2", Read(50.0 * LBF * IN)), ("0,12 kg.m²", "kg*m^2", Read(0.12)),
    ("0.12 kg-m^2", "kg*m^2", Read(0.12)), ("0.12 kgm^2", "kg*m^2", Refused(&[("kg*m", 0.12)])), ("250 gmm", "kg*m", Read(250e-6)), ("250 g-mm", "kg*m", Read(250e-6)),
    ("250 g·mm", "kg*m", Read(250e-6)), ("3 oz-in", "kg*m", Read(3.0 * OZ * IN)), ("3 oz in", "kg*m", Read(3.0 * OZ * IN)), ("0.25 kgmm", "kg*m", Read(250e-6)),
    // Ratios, volumes
    ("5 %", "1", Read(0.05)), ("5 percent", "1", Read(0.05)), ("0.05", "1", Read(0.05)), ("5 deg", "1", Refused(&[])), ("3 litros", "m^3", Read(0.003)),
    ("3 litres", "m^3", Read(0.003)), ("3 liters", "m^3", Read(0.003)), ("3 in/lb", "m/N", Refused(&[("3 in/lbf", 3.0 * IN / LBF)])),
    // Arithmetic
    ("(7850 kg/m^3)*pi/4*(200 mm)^2*50 mm", "kg", Read(7850.0 * PI / 4.0 * 0.04 * 0.05)), ("900 N/m*(0.8 m)^2", "N*m", Read(576.0)),
    ("900 N/m*0.8 m", "N", Read(720.0)), ("3 N/m*2", "N/m", Read(6.0)), ("10 kg*9.81 m/s^2", "N", Read(98.1)), ("9.81*10 N", "N", Read(98.1)), ("9.81*10 N-m", "N*m", Read(98.1)),
    ("60 lbf/(12 lb*in*(1500 rpm)^2)", "1", Read(60.0 * LBF / (12.0 * LB * IN * 1500.0 * RPM * 1500.0 * RPM))), ("1500 rpm/(50 rad/s)", "1", Read(30.0 * RPM)),
    ("(3 rad/s)/(2 1/s)", "1", Read(1.5)), ("(20 g)*(5 mm)*(100 rad/s)^2", "N", Read(1.0)), ("10 N/((2 mm)*(100 rad/s)^2)", "kg", Read(0.5)),
    ("12 g*120 mm", "kg*m", Read(0.00144)), ("3 N/2 mm", "N*m", Refused(&[("(3 N/2)*mm", 0.0015)])), ("10 N*m*60 rpm", "W", Read(20.0 * PI)),
    ("2*hertz", "Hz", Refused(&[("Hz", 2.0 * TAU)])), ("4*pi^2 N/m", "N/m", Read(4.0 * PI * PI)), ("210 GPa*(20 mm)^4/12", "N*m^2", Read(2800.0)), ("sqrt(40 kN/m/(10 kg))", "rad/s", Read(63.245_553_203_367_59)),
];

/// Text, unit of the field, components asked, and the components in SI or a repair of the refusal.
#[rustfmt::skip]
const VECTORS: &[(&str, &str, usize, Result<[f64; 3], &str>)] = &[
    ("(1; 1; 2) m", "m", 3, Ok([1.0, 1.0, 2.0])), ("(1, 1, 2) m", "m", 3, Ok([1.0, 1.0, 2.0])), ("(1,1,2) m", "m", 3, Ok([1.0, 1.0, 2.0])),
    ("(1,1, 2) m", "m", 3, Err("(1; 1; 2) m")), ("(1,1, 2) m", "m", 2, Ok([1.1, 2.0, 0.0])), ("(1,5; 2,5) m", "m", 2, Ok([1.5, 2.5, 0.0])),
    ("[0, 0, 1]", "m", 3, Ok([0.0, 0.0, 1.0])), ("[0; 0; 1]", "m", 3, Ok([0.0, 0.0, 1.0])), ("3 j + 10 k rad/s", "rad/s", 3, Ok([0.0, 3.0, 10.0])),
    ("(3 j + 10 k) rad/s", "rad/s", 3, Ok([0.0, 3.0, 10.0])), ("-2i + 3j N", "N", 2, Ok([-2.0, 3.0, 0.0])), ("−2 i + 3 j", "N", 3, Ok([-2.0, 3.0, 0.0])),
    ("{30i - 40j} lbf", "N", 2, Ok([30.0 * LBF, -40.0 * LBF, 0.0])), ("(3 ft, 6 in)", "m", 2, Ok([3.0 * FT, 6.0 * IN, 0.0])), ("3 N i + 4 N j", "N", 2, Ok([3.0, 4.0, 0.0])),
    ("80 lbf @ 0 deg", "N", 2, Ok([80.0 * LBF, 0.0, 0.0])), ("80 lbf ∠ 90°", "N", 2, Ok([0.0, 80.0 * LBF, 0.0])), ("5 m @ 180 graus", "m", 2, Ok([-5.0, 0.0, 0.0])),
    ("5 m @ 270°", "m", 2, Ok([0.0, -5.0, 0.0])), ("80 lb @ 30 deg", "N", 2, Err("80 lbf @ 30 deg")), ("5 m @ 30", "m", 2, Err("5 m @ 30 deg")),
    ("(0; 0; 10) lb", "N", 3, Err("(0; 0; 10) lbf")), ("(0; 0; 10) kg", "N", 3, Err("(0; 0; 10) kgf")), ("(1, 2, 3) m", "m", 2, Err("(3; 4) m")),
    ("5 N", "N", 3, Err("(3; 4; 0) N")), ("", "N", 3, Err("(3; 4; 0) N")), ("", "lbf", 2, Err("(3; 4) lbf")), ("(1 N; 2)", "N", 2, Err("(3; 4) N")),
];

#[test]
fn quantities_are_read_or_refused_with_repairs_that_work() {
    for (text, field, outcome) in QUANTITIES {
        let field = unit(field).unwrap();
        let kind =
            if matches!(field.ascii().as_str(), "N*m^2" | "kg/s") { Kind::Other } else { Kind::of(&field) };
        let read = |text: &str| read_quantity(text, &field, kind);
        match (read(text), outcome) {
            (Ok(quantity), Read(si)) => {
                assert!(near(quantity.si, *si), "`{text}`: {} in place of {si}", quantity.si);
            }
            (Err(error), Refused(repairs)) => {
                let typed = |repair: &str| read(&put(text, &error, repair)).or_else(|_| read(repair));
                for (repair, si) in *repairs {
                    assert!(shows(&error, repair), "`{text}`: {error}");
                    let quantity = typed(repair).unwrap_or_else(|why| panic!("`{text}`: {error}: {why}"));
                    assert!(near(quantity.si, *si), "`{text}`, `{repair}`: {} in place of {si}", quantity.si);
                }
                let offered = offered(&error);
                if is_repairable(&error) {
                    assert_eq!(error.repairs(), offered, "`{text}`: {error}");
                }
                let mut accepted = offered.iter().filter(|repair| typed(repair).is_ok());
                // Of two readings one may be of another kind.
                if matches!(error, ReadError::Gap { .. } | ReadError::Ambiguous { .. }) {
                    assert!(accepted.next().is_some(), "`{text}`: {error}");
                } else {
                    assert_eq!(accepted.count(), offered.len(), "`{text}`: {error}");
                }
            }
            (Ok(quantity), Refused(_)) => panic!("`{text}` was read as {quantity:?}"),
            (Err(error), Read(_)) => panic!("`{text}`: {error}"),
        }
    }
    assert!(QUANTITIES.len() >= 200, "{}", QUANTITIES.len());
}

#[test]
fn vectors_are_read_or_refused_with_repairs_that_work() {
    for (text, field, len, outcome) in VECTORS {
        let field = unit(field).unwrap();
        let read = |text: &str| read_vector(text, &field, Kind::of(&field), *len);
        match (read(text), outcome) {
            (Ok(vector), Ok(si)) => {
                let all = (0..3).all(|axis| near(vector.si[axis], si[axis]));
                assert!(all, "`{text}`: {:?} in place of {si:?}", vector.si);
            }
            (Err(error), Err(repair)) => {
                assert!(error.to_string().contains(repair), "`{text}`: {error}");
                for repair in offered(&error).into_iter().chain([(*repair).to_owned()]) {
                    assert!(read(&repair).is_ok(), "`{text}`: {error}: {:?}", read(&repair));
                }
            }
            (Ok(vector), Err(_)) => panic!("`{text}` was read as {vector:?}"),
            (Err(error), Ok(_)) => panic!("`{text}`: {error}"),
        }
    }
}

fn near(found: f64, wanted: f64) -> bool {
    (found - wanted).abs() <= 2e-15 * wanted.abs()
}

/// The text with a repair in place of the part at fault.
fn put(text: &str, error: &ReadError, repair: &str) -> String {
    let span = error.span().unwrap_or(0..text.len());
    format!("{}{repair}{}", &text[..span.start], &text[span.end..])
}

/// Returns true for an error whose repairs can be put in by a program that shows it: those of its message.
fn is_repairable(error: &ReadError) -> bool {
    use ReadError::{Ambiguous, Gap, SeveralUnits, TwoMarks, UnknownUnit, WrongKind};
    matches!(
        error,
        Ambiguous { .. }
            | Gap { .. }
            | SeveralUnits { .. }
            | TwoMarks { .. }
            | UnknownUnit { .. }
            | WrongKind(_)
    )
}

fn shows(error: &ReadError, repair: &str) -> bool {
    error.to_string().contains(&format!("`{repair}`"))
}

/// Texts that a message offers to write.
fn offered(error: &ReadError) -> Vec<String> {
    let message = error.to_string();
    let from = ["write ", "did you mean ", "arc: "].iter().filter_map(|word| message.rfind(word)).min();
    let advice = from.map_or("", |from| &message[from..]);
    advice.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}
