//! The lanes at work: cases are put into them, impacts are taken out, and a lane whose case has ended gets the next one.

use contract::{Ending, Limit};

use super::{
    CHUNK, Rows, Sequence, Tally, Work,
    blocks::{Blocks, Landed},
    lanes::Lanes,
    order,
    single::{Finished, Single},
};

/// How many impacts are collected before they are written to their rows.
const HELD: usize = 16;

/// The most lanes that there are.
const MOST_LANES: usize = 16;

/// A case in its lane.
#[derive(Clone, Copy)]
struct Place {
    case: usize,
    /// How many of its impacts are written.
    written: usize,
}

/// One quantity of the impacts that are not written yet, in all lanes.
type Held = [[f64; MOST_LANES]; HELD];

/// Lanes with the cases that are in them, in groups of a register each. A flight is a long chain of operations that wait for each other; the processor
/// works on the next group meanwhile.
struct Pool<'a, 'r, L: Lanes, const GROUPS: usize> {
    work: &'a Work<'a>,
    rows: &'a mut Rows<'r>,
    blocks: [Blocks<L>; GROUPS],
    /// What is in each lane, if anything.
    places: [Option<Place>; MOST_LANES],
    /// How many lanes are free.
    free: usize,
    /// The cases in the order in which they are taken, and how many are.
    order: [u16; CHUNK],
    next: usize,
    held: [Held; 3],
    count: usize,
    /// How many impacts may be held until a lane is full.
    room: usize,
    tally: Tally,
}

/// Follows all cases of the work, `GROUPS` registers at a time.
#[inline(always)]
pub(super) fn run<L: Lanes, const GROUPS: usize>(zero: L, work: &Work, rows: &mut Rows) -> Tally {
    let mut pool = Pool::<L, GROUPS> {
        work,
        rows,
        blocks: [Blocks::idle(zero); GROUPS],
        places: [None; MOST_LANES],
        free: GROUPS * L::COUNT,
        order: order::alike(work),
        next: 0,
        held: [[[0.0; MOST_LANES]; HELD]; 3],
        count: 0,
        room: 0,
        tally: Tally::default(),
    };
    // Flights to the side of the first, and then to the other: all lanes are on the same side.
    while pool.refill() {
        pool.fly::<true>();
        pool.fly::<false>();
    }
    pool.tally
}

impl<L: Lanes, const GROUPS: usize> Pool<'_, '_, L, GROUPS> {
    /// How many lanes there are.
    const LANES: usize = GROUPS * L::COUNT;

    /// Puts cases into the lanes that are free, if half of them are; whether any lane is busy then.
    ///
    /// To wait for half of them keeps the lanes in step: the first flights are long, and ask for more terms of the series than the later ones.
    #[inline(always)]
    fn refill(&mut self) -> bool {
        if 2 * self.free >= Self::LANES && self.next < self.work.epsilon.len() {
            self.write();
            self.take_cases();
            for blocks in &mut self.blocks {
                blocks.prepare();
            }
        }
        self.free < Self::LANES
    }

    /// Puts cases into the free lanes.
    #[inline(never)]
    fn take_cases(&mut self) {
        let Work { epsilon, omega, eta, impacts } = *self.work;
        let mut cases = self.order.iter().take(epsilon.len()).skip(self.next);
        for (lane, place) in self.places.iter_mut().enumerate().take(Self::LANES) {
            if place.is_some() {
                continue;
            }
            for case in cases.by_ref() {
                let case = usize::from(*case);
                self.next += 1;
                let (Some(epsilon), Some(omega), Some(eta)) = (epsilon.get(case), omega.get(case), eta.get(case))
                else {
                    continue;
                };
                if *epsilon > 0.0 {
                    if let Some(blocks) = self.blocks.get_mut(lane / L::COUNT) {
                        blocks.start(lane % L::COUNT, *epsilon, *omega, *eta);
                    }
                    *place = Some(Place { case, written: 0 });
                    self.free -= 1;
                    break;
                }
                self.rows.end(case, impacts, Sequence { impacts: 0, ending: Ending::NeverRocks });
            }
        }
        self.measure();
    }

    /// One flight of every lane.
    #[inline(always)]
    fn fly<const FIRST_SIDE: bool>(&mut self) {
        // One stage for all groups before the next: each is short enough that the processor has the next group's in sight.
        let mut starts = [None; GROUPS];
        for (start, blocks) in starts.iter_mut().zip(&self.blocks) {
            *start = Some(blocks.take_off());
        }
        let mut landings = [None; GROUPS];
        for ((landing, blocks), start) in landings.iter_mut().zip(&self.blocks).zip(&starts) {
            if let Some((start, guess)) = start {
                *landing = Some(blocks.land(start, *guess));
            }
        }
        let mut unsure = false;
        let mut landed = [None; GROUPS];
        let all = self.blocks.iter_mut().zip(&starts).zip(&landings).zip(&mut landed);
        for (group, (((blocks, start), landing), landed)) in all.enumerate() {
            let (Some((start, _)), Some(landing)) = (start, landing) else { continue };
            let flights = blocks.hit::<FIRST_SIDE>(start, landing);
            unsure |= L::any(flights.unsure);
            for (held, quantity) in self.held.iter_mut().zip([&flights.time, &flights.interval, &flights.velocity]) {
                if let Some(place) = held.get_mut(self.count).and_then(|lanes| lanes.get_mut(group * L::COUNT..)) {
                    quantity.copy_to(place);
                }
            }
            *landed = Some(flights);
        }
        if unsure {
            self.alone(&landed, if FIRST_SIDE { -1.0 } else { 1.0 });
        } else {
            self.count += 1;
        }
        if self.count == self.room {
            self.write();
            self.finish();
        } else if self.count == HELD {
            self.write();
        }
    }

    /// Writes the impacts that are held.
    #[inline(never)]
    fn write(&mut self) {
        let count = self.count;
        for (lane, place) in self.places.iter_mut().enumerate().take(Self::LANES) {
            let Some(place) = place else { continue };
            let start = place.case * self.work.impacts + place.written;
            for (row, held) in self.rows.quantities().into_iter().zip(&self.held) {
                let Some(row) = row.get_mut(start..start + count) else { continue };
                for (slot, lanes) in row.iter_mut().zip(held) {
                    *slot = lanes.get(lane).copied().unwrap_or(f64::NAN);
                }
            }
            place.written += count;
        }
        self.room = self.room.saturating_sub(count);
        self.count = 0;
    }

    /// Ends the cases that have all the impacts that are asked for.
    #[inline(never)]
    fn finish(&mut self) {
        for lane in 0..Self::LANES {
            let Some(Some(place)) = self.places.get(lane) else { continue };
            if place.written == self.work.impacts {
                let blocks = self.blocks.get(lane / L::COUNT);
                let complete = blocks.is_some_and(|blocks| blocks.complete.lane(lane % L::COUNT) == 1.0);
                self.end(lane, if complete { Ending::AtRest } else { Ending::LimitReached(Limit::Impacts) });
            }
        }
        self.measure();
    }

    /// How many impacts may be held until a lane is full.
    fn measure(&mut self) {
        let written = self.places.iter().flatten().map(|place| place.written);
        self.room = self.work.impacts - written.max().unwrap_or(0);
    }

    fn end(&mut self, lane: usize, ending: Ending) {
        if let Some(blocks) = self.blocks.get_mut(lane / L::COUNT) {
            blocks.busy.set_lane(lane % L::COUNT, 0.0);
        }
        if let Some(Place { case, written }) = self.places.get_mut(lane).and_then(Option::take) {
            self.free += 1;
            self.rows.end(case, self.work.impacts, Sequence { impacts: written, ending });
            self.tally.impacts += written as u64;
        }
    }

    /// The flights that the lanes are not sure of, by the scalar code; the others as they are. All are among the impacts that are held, but not counted yet.
    #[cold]
    #[inline(never)]
    fn alone(&mut self, landed: &[Option<Landed<L>>; GROUPS], sign: f64) {
        let mut last = [None; MOST_LANES];
        let mut gone = [None; MOST_LANES];
        for (lane, (last, gone)) in last.iter_mut().zip(&mut gone).enumerate().take(Self::LANES) {
            let (group, within) = (lane / L::COUNT, lane % L::COUNT);
            let (Some(Some(landed)), Some(blocks)) = (landed.get(group), self.blocks.get_mut(group)) else { continue };
            let zero = landed.time.all(0.0);
            if zero.all(1.0).or(landed.unsure, zero).lane(within) != 1.0 {
                continue;
            }
            self.tally.alone += 1;
            let mut single = Single::new(blocks, landed.before, sign, within);
            match single.fly() {
                Some(Finished { ending, listed: false }) => {
                    *gone = Some(ending);
                    continue;
                }
                Some(Finished { ending, .. }) => *last = Some(ending),
                None => {}
            }
            single.put_into(blocks, within);
            for (held, value) in self.held.iter_mut().zip(single.impact()) {
                if let Some(place) = held.get_mut(self.count).and_then(|lanes| lanes.get_mut(lane)) {
                    *place = value;
                }
            }
        }
        // What has ended without this impact is gone before it is written.
        if gone.iter().any(Option::is_some) {
            let held = self.held.map(|held| held.get(self.count).copied());
            self.write();
            for (to, from) in self.held.iter_mut().zip(held) {
                if let (Some(to), Some(from)) = (to.first_mut(), from) {
                    *to = from;
                }
            }
            self.end_all(gone);
        }
        self.count += 1;
        if last.iter().any(Option::is_some) {
            self.write();
            self.end_all(last);
        }
        self.measure();
    }

    fn end_all(&mut self, endings: [Option<Ending>; MOST_LANES]) {
        for (lane, ending) in endings.into_iter().enumerate() {
            if let Some(ending) = ending {
                self.end(lane, ending);
            }
        }
    }
}
