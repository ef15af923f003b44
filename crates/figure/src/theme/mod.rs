//! The one table from a mark's meaning to its colours and lines. Nothing else makes a colour.

pub mod fonts;
mod role;

pub use fonts::{Face, text_width};
pub use role::Role;

/// A colour, sRGB with straight (not premultiplied) alpha.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Color {
    /// Red.
    pub r: u8,
    /// Green.
    pub g: u8,
    /// Blue.
    pub b: u8,
    /// 255 covers, 0 is nothing.
    pub a: u8,
}

/// How a line is interrupted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dash {
    /// Not at all.
    Solid,
    /// Long parts.
    Dashed,
    /// Dots.
    Dotted,
    /// Parts twice as long.
    Long,
    /// Parts half as long.
    Short,
    /// A part and a dot in turn.
    DashDot,
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub color: Color,
    /// Its width in points.
    pub width: f32,
    /// How it is interrupted.
    pub dash: Dash,
}

/// How a role looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Lines and outlines, if any.
    pub stroke: Option<Stroke>,
    /// Inside of closed shapes, if filled; usually translucent.
    pub fill: Option<Color>,
    /// Whether closed shapes are hatched with thin lines in the stroke's colour.
    pub hatch: bool,
    /// Text of this role.
    pub text: Color,
}

/// What every role looks like.
#[derive(Debug, PartialEq)]
pub struct Theme {
    /// Its name on the command line.
    pub name: &'static str,
    /// Whether the page is darker than the text.
    pub dark: bool,
    page: Color,
    panel: Color,
    /// Lines between panels.
    rule: Color,
    text: Color,
    quiet: Color,
    edge: Color,
    /// Insides of primitives.
    scene: Color,
    here: Color,
    ray: Color,
    waiting: Color,
    test: Color,
    hit: Color,
    wrong: Color,
    hover: Color,
    /// Opacity of tinted boxes.
    tint: u8,
    /// How much of a primitive's colour its inside has once it was hit.
    solid: u8,
    /// Factor on all line widths.
    weight: f32,
}

impl Dash {
    /// Lengths of line and gap in points for a line of this width; empty when it is not interrupted.
    pub fn pattern(self, width: f32) -> &'static [f32] {
        match self {
            Dash::Solid => &[],
            Dash::Dashed if width < 2.0 => &[6.0, 4.0],
            Dash::Dashed => &[9.0, 5.0],
            Dash::Dotted => &[2.0, 3.5],
            Dash::Long => &[14.0, 5.0],
            Dash::Short => &[5.0, 4.0],
            Dash::DashDot => &[11.0, 4.0, 3.0, 4.0],
        }
    }
}

impl Color {
    const fn hex(rgb: u32) -> Color {
        Color { r: (rgb >> 16) as u8, g: (rgb >> 8) as u8, b: rgb as u8, a: 255 }
    }

    const fn alpha(self, a: u8) -> Color {
        Color { a, ..self }
    }

    /// Itself laid over an opaque colour.
    pub fn over(self, ground: Color) -> Color {
        let mix = |top: u8, below: u8| {
            let (top, below, a) = (u32::from(top), u32::from(below), u32::from(self.a));
            ((top * a + below * (255 - a) + 127) / 255) as u8
        };
        Color { r: mix(self.r, ground.r), g: mix(self.g, ground.g), b: mix(self.b, ground.b), a: 255 }
    }

    /// Itself made darker or lighter for shading: every channel times `by`, 1 leaves it.
    pub fn shaded(self, by: f32) -> Color {
        let channel = |c: u8| (f32::from(c) * by + 0.5).clamp(0.0, 255.0) as u8;
        Color { r: channel(self.r), g: channel(self.g), b: channel(self.b), a: self.a }
    }

    /// `#rrggbb`, without the alpha.
    pub fn to_hex(self) -> String {
        format!("#{:02x}{:02x}{:02x}", self.r, self.g, self.b)
    }
}

impl Theme {
    /// Ink on a warm white page.
    pub const LIGHT: Theme = Theme {
        name: "light",
        dark: false,
        page: Color::hex(0xFBFCF8),
        panel: Color::hex(0xFFFFFF),
        rule: Color::hex(0xD5D5CC),
        text: Color::hex(0x1B202B),
        quiet: Color::hex(0x4A5361),
        edge: Color::hex(0x7E8593),
        scene: Color::hex(0xECEEE8),
        here: Color::hex(0x0B5C9E),
        ray: Color::hex(0xB93A06),
        waiting: Color::hex(0x6F2F86),
        test: Color::hex(0x7A5F00),
        hit: Color::hex(0x00694F),
        wrong: Color::hex(0xA3005C),
        hover: Color::hex(0xF0C800),
        tint: 20,
        solid: 96,
        weight: 1.0,
    };

    /// Light on a dark page.
    pub const DARK: Theme = Theme {
        name: "dark",
        dark: true,
        page: Color::hex(0x14171D),
        panel: Color::hex(0x1B1F27),
        rule: Color::hex(0x343A46),
        text: Color::hex(0xECEFF4),
        quiet: Color::hex(0xB4BCC9),
        edge: Color::hex(0x7E8796),
        scene: Color::hex(0x2A303B),
        here: Color::hex(0x6CB8F2),
        ray: Color::hex(0xFF8A4C),
        waiting: Color::hex(0xCE9BE6),
        test: Color::hex(0xE0B93A),
        hit: Color::hex(0x3CC9A0),
        wrong: Color::hex(0xFF79B8),
        hover: Color::hex(0xF5D94A),
        tint: 40,
        solid: 96,
        weight: 1.0,
    };

    /// White page, deep colours and heavy lines, for the far end of a lecture hall.
    pub const PROJECTOR: Theme = Theme {
        name: "projector",
        dark: false,
        page: Color::hex(0xFFFFFF),
        panel: Color::hex(0xFFFFFF),
        rule: Color::hex(0xBFC3CA),
        text: Color::hex(0x0B0E14),
        quiet: Color::hex(0x343B47),
        edge: Color::hex(0x656D7B),
        scene: Color::hex(0xC9CFC3),
        here: Color::hex(0x05467C),
        ray: Color::hex(0x8C2900),
        waiting: Color::hex(0x5B1F72),
        test: Color::hex(0x574300),
        hit: Color::hex(0x004F3B),
        wrong: Color::hex(0x85004A),
        hover: Color::hex(0xF0C800),
        tint: 28,
        solid: 136,
        weight: 1.5,
    };

    /// White paper.
    pub const PRINT: Theme = Theme {
        name: "print",
        dark: false,
        page: Color::hex(0xFFFFFF),
        panel: Color::hex(0xFFFFFF),
        rule: Color::hex(0xC9CCD1),
        weight: 0.9,
        ..Theme::LIGHT
    };

    /// Every theme.
    pub const ALL: [&'static Theme; 4] = [&Theme::LIGHT, &Theme::DARK, &Theme::PROJECTOR, &Theme::PRINT];

    /// The theme of this name.
    pub fn named(name: &str) -> Option<&'static Theme> {
        Theme::ALL.into_iter().find(|theme| theme.name == name)
    }

    /// How a role looks.
    pub fn style(&self, role: Role) -> Style {
        use Dash::{DashDot, Dashed, Dotted, Long, Short, Solid};
        let stroke = |color, width: f32, dash| Some(Stroke { color, width: width * self.weight, dash });
        let tint = |color: Color| Some(color.alpha(self.tint));
        let look = |stroke, fill, text| Style { stroke, fill, hatch: false, text };
        let hatched = |stroke, fill, text| Style { stroke, fill, hatch: true, text };
        match role {
            Role::Scene => look(stroke(self.edge, 1.2, Solid), Some(self.scene), self.quiet),
            Role::Ray => look(stroke(self.ray, 1.6, Dashed), Some(self.ray), self.ray),
            Role::Line => look(stroke(self.ray, 1.0, Solid), None, self.ray),
            Role::Live => look(stroke(self.ray, 4.0, Solid), Some(self.ray), self.ray),
            Role::Lane => look(stroke(self.ray, 1.2, Solid), Some(self.ray), self.ray),
            Role::Thread1 => look(stroke(self.ray, 1.5, Solid), Some(self.ray), self.ray),
            Role::Thread2 => look(stroke(self.ray, 1.5, Long), Some(self.ray), self.ray),
            Role::Thread3 => look(stroke(self.ray, 1.5, Short), Some(self.ray), self.ray),
            Role::Thread4 => look(stroke(self.ray, 1.5, DashDot), Some(self.ray), self.ray),
            Role::Strand1 => look(stroke(self.ray, 4.0, Solid), Some(self.ray), self.ray),
            Role::Strand2 => look(stroke(self.ray, 4.0, Long), Some(self.ray), self.ray),
            Role::Strand3 => look(stroke(self.ray, 4.0, Short), Some(self.ray), self.ray),
            Role::Strand4 => look(stroke(self.ray, 4.0, DashDot), Some(self.ray), self.ray),
            Role::Tick => look(stroke(self.ray, 2.0, Solid), Some(self.page), self.ray),
            Role::Here => look(stroke(self.here, 3.2, Solid), tint(self.here), self.here),
            Role::Seen => look(stroke(self.here, 1.3, Solid), None, self.here),
            Role::Waiting => look(stroke(self.waiting, 2.2, Dashed), tint(self.waiting), self.waiting),
            Role::Dropped => look(stroke(self.edge, 1.8, Dotted), Some(self.page.alpha(96)), self.quiet),
            Role::Missed => hatched(stroke(self.test, 1.5, Solid), tint(self.test), self.test),
            Role::Hit => look(stroke(self.hit, 1.8, Solid), Some(self.hit.alpha(self.solid)), self.hit),
            Role::Best => look(stroke(self.hit, 3.0, Solid), Some(self.hit.alpha(200)), self.hit),
            Role::Plane => look(stroke(self.here, 2.4, Solid), tint(self.here), self.here),
            Role::Candidate => look(stroke(self.test, 2.4, Solid), None, self.test),
            Role::Below => hatched(stroke(self.here, 1.5, Solid), tint(self.here), self.here),
            Role::Above => look(stroke(self.quiet, 1.5, Dashed), Some(self.edge.alpha(self.tint + 20)), self.quiet),
            Role::Guess => look(stroke(self.here, 1.8, Dotted), None, self.here),
            Role::Hover => look(stroke(self.text, 2.6, Solid), Some(self.hover.alpha(96)), self.text),
            Role::Edge => look(stroke(self.edge, 1.0, Solid), None, self.quiet),
            Role::Filled => look(stroke(self.edge, 1.0, Solid), Some(self.edge.alpha(self.tint + 14)), self.quiet),
            Role::LiveBehind => look(stroke(self.ray.alpha(190), 4.0, Short), None, self.ray),
            Role::Hidden => look(stroke(self.edge, 0.9, Dotted), None, self.quiet),
            Role::Ghost => look(stroke(self.edge, 2.8, Dotted), None, self.quiet),
            Role::Wrong => hatched(stroke(self.wrong, 3.2, Dashed), tint(self.wrong), self.wrong),
            Role::Text => look(stroke(self.text, 1.2, Solid), None, self.text),
            Role::Quiet => look(stroke(self.quiet, 1.0, Solid), None, self.quiet),
            Role::Value => look(stroke(self.ray, 1.6, Solid), tint(self.ray), self.ray),
            Role::Ground => look(None, tint(self.here), self.here),
            Role::Page => look(None, Some(self.page), self.text),
            Role::Panel => look(stroke(self.rule, 1.0, Solid), Some(self.panel), self.text),
        }
    }

    /// Nothing at all, in the colour of surfaces.
    pub(crate) fn clear(&self) -> Color {
        self.surface(1.0).alpha(0)
    }

    /// A surface in light of this strength, 0 to 1.
    pub(crate) fn surface(&self, light: f32) -> Color {
        let (dim, bright) = if self.dark { (0.9, 2.3) } else { (0.55, 1.0) };
        self.scene.shaded(dim + (bright - dim) * light)
    }

    /// How a boxed text of a role looks: the box's outline and fill, and the text on it. Only the current
    /// place has a solid one.
    pub fn label(&self, role: Role) -> Style {
        let text = self.style(role).text;
        let outline = |width: f32, dash| Some(Stroke { color: text, width: width * self.weight, dash });
        let plain = |stroke| Style { stroke, fill: Some(self.panel), hatch: false, text };
        match role {
            Role::Here | Role::Best | Role::Lane => {
                Style { stroke: outline(1.2, Dash::Solid), fill: Some(text), hatch: false, text: self.page }
            }
            Role::Dropped => plain(outline(1.0, Dash::Dotted)),
            _ => plain(outline(1.2, Dash::Solid)),
        }
    }
}
