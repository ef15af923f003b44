//! Figures as files, without a GPU: SVG, PNG, APNG, GIF, JSON.
