//! Markdown set in a column: words wrapped, bold, code, formulas.

use glam::Vec2;
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd, TextMergeStream};
use raystep_figure::{Anchor, Face, Figure, Ink, Role, fonts};

use crate::formula::extent;
use crate::typefaces::Typeface;

/// A text in a column of this width; the height of the figure is what it takes. `size` is that of the
/// letters, `face` that of plain words.
pub fn prose(markdown: &str, width: f32, size: f32, face: Face, role: Role) -> Figure {
    let mut setter = Setter {
        figure: Figure::new(Vec2::new(width, 0.0)),
        size,
        plain: face,
        role,
        line: Vec::new(),
        filled: 0.0,
        word: Vec::new(),
        y: 0.0,
        bottom: 0.0,
        indent: 0.0,
    };
    let (mut bold, mut italic, mut fenced) = (0, 0, false);
    // The parser cuts a text at brackets that might have begun a link.
    for event in TextMergeStream::new(Parser::new_ext(markdown, Options::ENABLE_MATH)) {
        match event {
            Event::Start(Tag::Strong) => bold += 1,
            Event::End(TagEnd::Strong) => bold -= 1,
            Event::Start(Tag::Emphasis) => italic += 1,
            Event::End(TagEnd::Emphasis) => italic -= 1,
            Event::Start(Tag::CodeBlock(_)) => {
                setter.paragraph();
                fenced = true;
            }
            Event::End(TagEnd::CodeBlock) => {
                setter.paragraph();
                fenced = false;
            }
            Event::Start(Tag::Item) => {
                setter.line_end();
                setter.indent = size * 1.1;
                setter.bullet();
            }
            Event::End(TagEnd::Item) => {
                setter.line_end();
                setter.indent = 0.0;
            }
            Event::End(TagEnd::Paragraph | TagEnd::Heading(_) | TagEnd::List(_)) => setter.paragraph(),
            Event::Text(text) if fenced => {
                for line in text.lines() {
                    setter.piece(Piece::text(line, Face::Mono, size));
                    setter.line_end();
                }
            }
            Event::Text(text) => {
                let face = match (bold, italic) {
                    (0, 0) => face,
                    (0, _) => Face::Italic,
                    _ => Face::Bold,
                };
                setter.words(&text, face);
            }
            Event::Code(code) => setter.words(&code, Face::Mono),
            Event::InlineMath(tex) => setter.piece(Piece::formula(&tex, size)),
            Event::DisplayMath(tex) => setter.display(&tex),
            Event::SoftBreak => setter.space(),
            Event::HardBreak => setter.line_end(),
            _ => {}
        }
    }
    setter.finish()
}

/// Lines stand this many sizes apart.
const LEADING: f32 = 1.5;
/// Paragraphs stand this many sizes further apart.
const GAP: f32 = 0.6;

/// Signs that stay with what they relate.
const RELATIONS: [&str; 8] = ["=", "<", ">", "≤", "≥", "←", "·", "/"];

/// Words that stay with the number behind them.
const KINDS: [&str; 5] = ["node", "cell", "primitive", "slide", "step"];

/// What is never broken.
#[derive(Clone)]
struct Piece {
    content: Content,
    width: f32,
    height: f32,
    depth: f32,
}

#[derive(Clone)]
enum Content {
    Text(String, Face, f32),
    Formula(String, f32),
    Space,
}

impl Piece {
    fn text(text: &str, face: Face, size: f32) -> Piece {
        // Code looks larger than the text around it.
        let size = if matches!(face, Face::Mono | Face::MonoMedium) { size * 0.94 } else { size };
        Piece {
            width: fonts::text_width(text, face, size),
            height: size * 0.8,
            depth: size * 0.2,
            content: Content::Text(text.to_owned(), face, size),
        }
    }

    fn formula(tex: &str, size: f32) -> Piece {
        // Formulas are set in a face with smaller letters.
        let size = size * 1.12;
        let room = extent(tex, size);
        Piece {
            width: room.width,
            height: room.height,
            depth: room.depth,
            content: Content::Formula(tex.to_owned(), size),
        }
    }

    /// Itself, or if it is a text that is wider than `room`, its parts that are not.
    fn broken(self, room: f32) -> Vec<Piece> {
        let Content::Text(text, face, size) = &self.content else { return vec![self] };
        if self.width <= room {
            return vec![self];
        }
        let part = |text: &str, width: f32| Piece {
            content: Content::Text(text.to_owned(), *face, *size),
            width,
            height: self.height,
            depth: self.depth,
        };
        let ends = fonts::pens(text, *face, *size).map(|(index, _, pen)| (index, pen));
        // Where this part begins, and where the letter before does.
        let (mut first, mut last) = ((0, 0.0), (0, 0.0));
        let mut parts = Vec::new();
        for end in ends.chain([(text.len(), self.width)]) {
            if end.1 - first.1 > room && last.0 > first.0 {
                parts.push(part(&text[first.0..last.0], last.1 - first.1));
                first = last;
            }
            last = end;
        }
        parts.push(part(&text[first.0..], self.width - first.1));
        parts
    }

    fn space(face: Face, size: f32) -> Piece {
        Piece { content: Content::Space, width: fonts::text_width(" ", face, size), height: 0.0, depth: 0.0 }
    }
}

struct Setter {
    figure: Figure,
    size: f32,
    plain: Face,
    role: Role,
    /// Words of the current line, with the spaces between them.
    line: Vec<Piece>,
    /// How wide they are.
    filled: f32,
    /// Pieces since the last space: wrapped together.
    word: Vec<Piece>,
    y: f32,
    /// Where the last line ended.
    bottom: f32,
    indent: f32,
}

impl Setter {
    fn words(&mut self, text: &str, face: Face) {
        let mut before = "";
        for (index, part) in text.split([' ', '\n']).enumerate() {
            let interval = before.starts_with('[') && before.ends_with(',');
            let named = KINDS.contains(&before.to_lowercase().as_str())
                && part.starts_with(|letter: char| letter.is_ascii_digit());
            if index > 0 && (interval || named || RELATIONS.contains(&part) || RELATIONS.contains(&before)) {
                // An equation is not torn apart, nor is an interval.
                self.piece(Piece::space(self.plain, self.size));
            } else if index > 0 {
                self.space();
            }
            before = part;
            if !part.is_empty() {
                self.piece(Piece::text(part, face, self.size));
            }
        }
    }

    fn piece(&mut self, piece: Piece) {
        self.word.push(piece);
    }

    fn space(&mut self) {
        self.word_end();
        if !self.line.is_empty() {
            self.place(Piece::space(self.plain, self.size));
        }
    }

    /// Puts the finished word on this line, or on the next if it does not fit; a word that is wider than the
    /// column is broken where it must.
    fn word_end(&mut self) {
        let room = self.figure.size.x - self.indent;
        let word = std::mem::take(&mut self.word);
        let width = word.iter().map(|piece| piece.width).sum::<f32>();
        if !self.line.is_empty() && self.filled + width > room {
            self.break_line();
        }
        if width <= room {
            return word.into_iter().for_each(|piece| self.place(piece));
        }
        for part in word.into_iter().flat_map(|piece| piece.broken(room)) {
            if !self.line.is_empty() && self.filled + part.width > room {
                self.break_line();
            }
            self.place(part);
        }
    }

    /// Puts a piece at the end of the line.
    fn place(&mut self, piece: Piece) {
        self.filled += piece.width;
        self.line.push(piece);
    }

    fn line_end(&mut self) {
        self.word_end();
        self.break_line();
    }

    fn paragraph(&mut self) {
        self.line_end();
        if self.y > 0.0 {
            self.y += self.size * GAP;
        }
    }

    /// A formula on a line of its own.
    fn display(&mut self, tex: &str) {
        self.line_end();
        self.y += self.size * GAP * 0.6;
        let indent = self.indent;
        self.indent += self.size;
        let mut size = self.size * 1.1;
        let width = Piece::formula(tex, size).width;
        let room = self.figure.size.x - self.indent;
        if width > room {
            size *= room / width;
        }
        self.place(Piece::formula(tex, size));
        self.break_line();
        self.indent = indent;
        self.y += self.size * GAP * 0.6;
    }

    fn bullet(&mut self) {
        let center = Vec2::new(self.size * 0.4, self.y + self.size * (LEADING * 0.5));
        let (x, y) = (center.x, center.y);
        let dot = Ink::Text {
            at: Vec2::new(x, y),
            text: "·".to_owned(),
            size: self.size * 1.3,
            face: Face::Bold,
            anchor: Anchor::Middle,
            boxed: false,
        };
        self.figure.add(self.role, None, dot);
    }

    /// Sets the line.
    fn break_line(&mut self) {
        self.filled = 0.0;
        while matches!(self.line.last(), Some(Piece { content: Content::Space, .. })) {
            self.line.pop();
        }
        if self.line.is_empty() {
            return;
        }
        let above = self.line.iter().fold(self.size * 0.8, |most, piece| most.max(piece.height));
        let below = self.line.iter().fold(self.size * 0.2, |most, piece| most.max(piece.depth));
        let air = self.size * (LEADING - 1.0);
        let baseline = self.y + air * 0.5 + above;
        let mut x = self.indent;
        for piece in self.line.drain(..) {
            let ink = match piece.content {
                Content::Space => None,
                Content::Formula(tex, size) => Some(Ink::Formula { at: Vec2::new(x, baseline), tex, size }),
                Content::Text(text, face, size) => {
                    let middle = baseline - Typeface::Text(face).middle() * size;
                    let at = Vec2::new(x, middle);
                    Some(Ink::Text { at, text, size, face, anchor: Anchor::Start, boxed: false })
                }
            };
            if let Some(ink) = ink {
                self.figure.add(self.role, None, ink);
            }
            x += piece.width;
        }
        self.y += above + below + air;
        self.bottom = self.y;
    }

    fn finish(mut self) -> Figure {
        self.line_end();
        self.figure.size.y = self.bottom;
        self.figure
    }
}
