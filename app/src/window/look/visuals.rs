//! A theme as egui's colours, spacing and text sizes. The only place where the theme's colours become egui's.

use egui::style::{Selection, WidgetVisuals, Widgets};
use egui::{Color32, CornerRadius, Shadow, Stroke, Style, TextStyle, Visuals, vec2};
use raystep_figure::{Color, Face, Role, Theme};

use super::fonts::font;

/// The theme's colour for egui.
#[allow(clippy::disallowed_methods, reason = "this is where the theme's colours enter egui")]
pub(crate) fn color32(color: Color) -> Color32 {
    Color32::from_rgba_unmultiplied(color.r, color.g, color.b, color.a)
}

/// The colour of text in a role.
pub(crate) fn ink(theme: &Theme, role: Role) -> Color32 {
    color32(theme.style(role).text)
}

/// The fill of a role, nothing if it has none.
pub(crate) fn fill(theme: &Theme, role: Role) -> Color32 {
    theme.style(role).fill.map(color32).unwrap_or_default()
}

/// The line of a role, nothing if it has none.
pub(crate) fn line(theme: &Theme, role: Role) -> Stroke {
    theme.style(role).stroke.map_or(Stroke::NONE, |stroke| Stroke::new(stroke.width, color32(stroke.color)))
}

/// Everything egui needs to draw its own widgets in a theme.
pub(crate) fn style(theme: &Theme) -> Style {
    let mut style = Style { visuals: visuals(theme), ..Style::default() };
    style.text_styles = [
        (TextStyle::Small, font(Face::Regular, 12.0)),
        (TextStyle::Body, font(Face::Regular, 14.5)),
        (TextStyle::Button, font(Face::Medium, 13.5)),
        (TextStyle::Monospace, font(Face::Mono, 13.5)),
        (TextStyle::Heading, font(Face::Bold, 22.0)),
    ]
    .into();
    let spacing = &mut style.spacing;
    spacing.item_spacing = vec2(8.0, 8.0);
    spacing.button_padding = vec2(11.0, 4.0);
    spacing.interact_size = vec2(30.0, 28.0);
    spacing.menu_margin = egui::Margin::same(6);
    spacing.combo_height = 460.0;
    // A list is as long as the window has room for; what an area begins with would be its bound.
    spacing.default_area_size = vec2(600.0, 4000.0);
    style.interaction.tooltip_delay = 0.4;
    style.interaction.selectable_labels = false;
    style.animation_time = 0.08;
    #[cfg(debug_assertions)]
    {
        style.debug.show_unaligned = false;
    }
    style
}

fn visuals(theme: &Theme) -> Visuals {
    let (page, panel) = (fill(theme, Role::Page), fill(theme, Role::Panel));
    let (text, quiet) = (ink(theme, Role::Text), ink(theme, Role::Quiet));
    let (here, rule) = (ink(theme, Role::Here), line(theme, Role::Panel));
    let soft = color32(theme.style(Role::Scene).fill.unwrap_or(theme.style(Role::Quiet).text));
    let tint = tinted(theme);
    let widget = |fill: Color32, bg_stroke: Stroke, text: Color32| WidgetVisuals {
        bg_fill: fill,
        weak_bg_fill: fill,
        bg_stroke,
        corner_radius: CornerRadius::same(5),
        fg_stroke: Stroke::new(1.2, text),
        expansion: 0.0,
    };
    let edge = Stroke::new(1.2, here);
    let base = if theme.dark { Visuals::dark() } else { Visuals::light() };
    Visuals {
        widgets: Widgets {
            noninteractive: widget(panel, rule, text),
            inactive: widget(panel, rule, text),
            hovered: widget(soft, edge, text),
            active: widget(tint, edge, text),
            open: widget(soft, edge, text),
        },
        selection: Selection { bg_fill: tint, stroke: Stroke::new(1.2, here) },
        weak_text_color: Some(quiet),
        hyperlink_color: here,
        faint_bg_color: soft,
        extreme_bg_color: page,
        code_bg_color: soft,
        warn_fg_color: ink(theme, Role::Live),
        error_fg_color: ink(theme, Role::Wrong),
        window_corner_radius: CornerRadius::same(8),
        window_fill: panel,
        window_stroke: rule,
        window_shadow: Shadow { offset: [0, 4], blur: 16, spread: 0, color: text.gamma_multiply(0.12) },
        popup_shadow: Shadow { offset: [0, 3], blur: 10, spread: 0, color: text.gamma_multiply(0.12) },
        menu_corner_radius: CornerRadius::same(6),
        panel_fill: page,
        ..base
    }
}

/// The ground of what is chosen: the current place's colour laid over a panel.
pub(crate) fn tinted(theme: &Theme) -> Color32 {
    let panel = theme.style(Role::Panel).fill;
    match (theme.style(Role::Here).fill, panel) {
        (Some(tint), Some(panel)) => color32(tint.over(panel)),
        _ => fill(theme, Role::Here),
    }
}
