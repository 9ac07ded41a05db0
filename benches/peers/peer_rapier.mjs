// Rapier (Rust, as WebAssembly from the npm registry, single precision): a rectangle on a floor that is shaken, as in block.py. And the protocol in JavaScript.
import RAPIER from "../../target/peers/node/node_modules/@dimforge/rapier2d-compat/dist/rapier.mjs";
import { createInterface } from "node:readline";

const STEPS = Number(process.env.STEPS ?? 20000); // of half a period
const LEAST = 3; // steps that a flight has to last in order to be listed
const STILL = 1e-5; // rotations, of alpha, that single precision can't tell from 0

class Decline extends Error {
  constructor(reason, why) {
    super(why);
    this.refusal = { reason, why };
  }
}

/** The measures of the block: see block.py. */
function body({ alpha, eta }) {
  const [sine, cosine] = [Math.sin(alpha), Math.cos(alpha)];
  const aboutCorner = (2 * sine * sine) / (1 - eta);
  if (aboutCorner < 1.001) {
    throw new Decline("no such block", `1 - eta = ${1 - eta} of a block that neither slides nor bounces is below ${2 * sine * sine}`);
  }
  return { b: sine, h: cosine, inertia: aboutCorner - 1, gravity: aboutCorner, shake: aboutCorner * Math.tan(alpha) };
}

/** The angle and its rate after each step. */
function* states({ alpha, eta, epsilon, omega }, step, steps) {
  const { b, h, inertia, gravity, shake } = body({ alpha, eta });
  const r = Math.sqrt(epsilon * (2 + epsilon));
  const world = new RAPIER.World({ x: 0, y: -gravity });
  try {
    world.timestep = step;
    const P = world.integrationParameters, env = process.env;
    if (env.IT) P.numSolverIterations = Number(env.IT);
    if (env.PGS) P.numInternalPgsIterations = Number(env.PGS);
    if (env.ALE) P.normalizedAllowedLinearError = Number(env.ALE);
    if (env.PRED) P.normalizedPredictionDistance = Number(env.PRED);
    if (env.FREQ) P.contact_natural_frequency = Number(env.FREQ);
    // The centre of mass is the origin: single precision has most digits there.
    const floor = RAPIER.ColliderDesc.cuboid(50, 1).setTranslation(0, -1 - h).setFriction(100).setRestitution(0);
    world.createCollider(floor);
    const mass = RAPIER.RigidBodyDesc.dynamic().setAdditionalMassProperties(1, { x: 0, y: 0 }, inertia).setCanSleep(false);
    const block = world.createRigidBody(mass);
    world.createCollider(RAPIER.ColliderDesc.cuboid(b, h).setDensity(0).setFriction(100).setRestitution(0), block);
    for (let n = 0; n < steps; n++) {
      const angle = omega * (n + 0.5) * step;
      world.gravity = { x: -shake * (Math.cos(angle) + r * Math.sin(angle)), y: -gravity };
      world.step();
      // Turning to the left is negative for the paper and positive for Rapier.
      yield [(n + 1) * step, -block.rotation() / alpha, -block.angvel() / alpha];
    }
  } finally {
    world.free();
  }
}

/** The impacts: as listed() of block.py. */
function listed(question, step, row) {
  const [time, velocity] = [[], []];
  let [side, before, moved, isListing, isUp, last] = [-1, null, 0, true, false, 0];
  const still = Math.max(4 * STILL, (LEAST * step) ** 2);
  for (const [now, phi, rate] of row) {
    if (!(Math.abs(phi) < 10)) return { time, velocity, ending: Number.isFinite(phi) ? "overturned" : "lost" };
    if (Math.abs(phi) > still) moved = now;
    isUp ||= side * phi > STILL;
    if (isUp && side * phi < 0) {
      const [start, height, speed] = before;
      const landed = start + (speed * side < 0 ? Math.min(Math.abs(height / speed), step) : step);
      if (time.length > 0 && landed - time.at(-1) < LEAST * step) isListing = false;
      if (isListing) {
        time.push(landed);
        velocity.push(rate);
        if (time.length === question.impacts) return { time, velocity, ending: "limit-reached" };
      }
      [side, isUp] = [-side, false];
    }
    before = [now, phi, rate];
    last = phi;
  }
  if (Math.abs(last) > still) return { time, velocity, ending: question.until === "half-period" ? "incomplete" : "limit-reached" };
  if (time.length === 0) return { time, velocity, ending: "lost", "x-why": "it never rocked" };
  return { time, velocity, ending: "at-rest", tau_ch: Math.max(moved, time.at(-1)) };
}

function answer(question) {
  if (question.model !== "nonlinear") return { decline: { reason: "another model", why: "a rigid block is not linear" } };
  if (question.epsilon <= 0) return { history: { time: [], velocity: [], ending: "never-rocks" } };
  const began = process.cpuUsage();
  try {
    const step = Math.PI / question.omega / STEPS;
    const steps = question.until === "half-period" ? STEPS : Math.round(question.until / step);
    if (steps > 20 * STEPS) throw new Decline("too long", `${steps} steps`);
    const history = listed(question, step, states(question, step, steps));
    const { user, system } = process.cpuUsage(began);
    return { history, ns: 1000 * (user + system) };
  } catch (error) {
    return error instanceof Decline ? { decline: error.refusal } : { error: { message: String(error) } };
  }
}

const say = (message) => process.stdout.write(JSON.stringify(message, (_, value) => (Object.is(value, -0) ? RAW_ZERO : value)).replaceAll(`"${RAW_ZERO}"`, "-0.0") + "\n");
const RAW_ZERO = "minus zero"; // JSON.stringify drops the sign of -0

console.log = console.info = console.warn = console.error; // standard output is for answers only
await RAPIER.init();
for await (const line of createInterface({ input: process.stdin })) {
  const question = JSON.parse(line);
  if (question.cmd === "start") {
    const engine = { name: "Rapier", version: RAPIER.version(), language: "JavaScript" };
    say({ version: 1, engine, models: ["nonlinear"], normalisations: ["threshold"], ground: ["sine"], echo: question.echo });
  } else if (question.cmd === "case") say({ seq: question.seq, ...answer(question) });
  else break;
}
