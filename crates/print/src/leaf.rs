//! A page that is read aloud to those who do not see it: which marks belong together, and what they say.

use std::num::NonZeroU16;
use std::ops::Range;

use krilla::surface::Surface;
use krilla::tagging::{Artifact, ArtifactType, ContentTag, Identifier, Node, Tag, TagGroup, TagKind};
use raystep_figure::Figure;

/// A page of a PDF file.
#[derive(Clone, Copy, Debug)]
pub struct Leaf<'a> {
    /// What stands on it.
    pub figure: &'a Figure,
    /// Its marks as they are read, one passage after the other. What belongs to none is not read: a page's number.
    /// Without any the page is not told at all.
    pub passages: &'a [Passage],
}

/// Marks that are read as one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Passage {
    /// The marks by their places in the figure.
    pub marks: Range<usize>,
    /// What they are.
    pub kind: Reading,
    /// How they are read.
    pub says: String,
}

/// What marks are to those who hear them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// The heading of what follows.
    Heading,
    /// A picture.
    Picture,
    /// Words, and formulas among them.
    Words,
}

impl Passage {
    fn tag(&self) -> TagKind {
        let says = Some(self.says.clone());
        match self.kind {
            Reading::Heading => Tag::Hn(NonZeroU16::MIN, says).into(),
            Reading::Picture => Tag::Figure(says).into(),
            Reading::Words => Tag::P.with_alt_text(says).into(),
        }
    }
}

/// Tells, mark by mark as they are drawn, what is read of them.
pub(crate) struct Teller<'a> {
    passages: &'a [Passage],
    /// The pieces of each passage that were drawn.
    drawn: Vec<Vec<Identifier>>,
    /// What is being drawn: a passage, or what belongs to none.
    open: Option<Option<usize>>,
}

impl<'a> Teller<'a> {
    pub(crate) fn new(passages: &'a [Passage]) -> Teller<'a> {
        Teller { passages, drawn: vec![Vec::new(); passages.len()], open: None }
    }

    /// A mark comes next, or the ground of the page, which is none.
    pub(crate) fn comes(&mut self, mark: Option<usize>, surface: &mut Surface<'_>) {
        if self.passages.is_empty() {
            return;
        }
        let holds = |passage: &Passage| mark.is_some_and(|mark| passage.marks.contains(&mark));
        let next = self.passages.iter().position(holds);
        if self.open == Some(next) {
            return;
        }
        self.ends(surface);
        match next {
            Some(passage) => self.drawn[passage].push(surface.start_tagged(ContentTag::Other)),
            None => {
                let besides = Artifact::with_kind(ArtifactType::Other);
                surface.start_tagged(ContentTag::Artifact(besides));
            }
        }
        self.open = Some(next);
    }

    /// Nothing comes any more.
    pub(crate) fn ends(&mut self, surface: &mut Surface<'_>) {
        if self.open.take().is_some() {
            surface.end_tagged();
        }
    }

    /// All that was drawn, in the order in which it is read; nothing where nothing is.
    pub(crate) fn told(self) -> Option<TagGroup> {
        let parts = self.passages.iter().zip(self.drawn).filter(|(_, drawn)| !drawn.is_empty());
        let parts = parts.map(|(passage, drawn)| {
            let drawn = drawn.into_iter().map(Node::from).collect();
            Node::from(TagGroup::with_children(passage.tag(), drawn))
        });
        let parts: Vec<Node> = parts.collect();
        (!parts.is_empty()).then(|| TagGroup::with_children(Tag::Section, parts))
    }
}
