//! How well a packet's lanes are used.

use crate::{Abreast, Observer, PacketStep, PacketVisit};

/// Counts visits and who takes part in them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fill {
    /// Nodes entered, leaves included, once for all lanes.
    pub visits: u64,
    /// Nodes entered, summed over the lanes that entered them.
    pub lane_visits: u64,
    /// Lanes there were at these visits, whether they took part or not.
    pub lanes: u64,
}

impl Fill {
    /// The share of the lanes that took part, from 0 to 1; nothing before the first visit.
    pub fn share(&self) -> Option<f32> {
        (self.lanes > 0).then(|| (self.lane_visits as f64 / self.lanes as f64) as f32)
    }
}

impl Observer<PacketVisit> for Fill {
    fn on(&mut self, event: PacketVisit) {
        if let PacketStep::Packet(Abreast::Enter { .. }) = event.step {
            self.visits += 1;
            self.lane_visits += u64::from(event.lanes.count());
            self.lanes += event.lanes.width() as u64;
        }
    }
}
