// validate.js FILE.glb...: the report of the Khronos glTF validator. Exit code 1 for any error or warning.
const fs = require("fs");
const validator = require("gltf-validator");

async function judge(file) {
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
  const issues = report.issues;
  console.log(`${file}: ${issues.numErrors} errors, ${issues.numWarnings} warnings, ` +
              `${issues.numInfos} infos; ${report.info.totalVertexCount} vertices, ` +
              `${report.info.totalTriangleCount} triangles`);
  for (const message of issues.messages) {
    console.log(`  ${message.code} ${message.pointer}: ${message.message}`);
  }
  return issues.numErrors + issues.numWarnings === 0;
}

Promise.all(process.argv.slice(2).map(judge)).then((sound) => {
  if (!sound.every(Boolean)) process.exit(1);
});
